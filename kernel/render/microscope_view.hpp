// SPDX-License-Identifier: GPL-3.0-or-later
// The picture of an eye: its surfaces, the lens by its optical depth, the instruments, light and lamps put together.
#pragma once

#include <array>
#include <optional>

#include "render/crack_layer.hpp"
#include "render/depth_pass.hpp"
#include "render/eye_textures.hpp"
#include "render/eyepiece.hpp"
#include "render/lens_front.hpp"
#include "render/pass_clock.hpp"
#include "render/pupil_changes.hpp"
#include "render/sheet_layer.hpp"
#include "render/tool_layer.hpp"

namespace rhexis {

/// Where in the picture cornea and pupil can show.
struct EyeAreas {
    PixelRect cornea;
    PixelRect pupil;
};
EyeAreas eye_areas(const EyeAnatomy& eye, const View& outer, const View& inner);

class MicroscopeView {
public:
    /// keeps_light: from picture to picture, where nothing has changed. Else each is drawn anew, which is the
    /// reference.
    static Result<MicroscopeView> create(int width, int height, bool keeps_light);

    /// frame.eye is not null; depth has drawn this frame through the same `inner` view. The result lies in picture().
    /// detail: repeating noise. stop_pixels: radius about the middle beyond which nothing is drawn; 0: all is.
    void draw(ToolPainter& painter, const Frame& frame, const std::vector<ToolMesh>& tools, const View& outer,
              const View& inner, const DepthPass& depth, const Texture& detail, double stop_pixels, PassClock& clock);

    /// A matte card as high as the limbus of this eye, in its place.
    void draw_card(double reflectance, const EyeAnatomy& eye, const View& outer);

    [[nodiscard]] const Target& picture() const { return picture_; }  ///< light, linear, before the film
    /// Of the picture that was drawn, for the eyepiece.
    [[nodiscard]] EyepieceLayers layers(const DepthPass& depth) const {
        return {picture_.colours[0],
                inside_.picture(),
                outside_.picture(),
                front_.surface(),
                depth.reference(),
                tools_,
                painted_,
                disturbed_};
    }

private:
    /// Smaller pictures on the way to the whole one.
    struct Steps {
        Program light;
        Program soften;
        Program shadows;
        Program card;
    };
    /// What the textures were made for.
    struct PaintedFor {
        double limbus_radius = 0.0;
        bool iris = false;
        bool cornea = false;
        bool operator==(const PaintedFor&) const = default;
    };
    /// Bands of the picture.
    struct Regions {
        std::vector<PixelRect> white;  ///< beyond the limbus
        std::vector<PixelRect> iris;
        std::vector<PixelRect> edge;    ///< of the pupil
        std::vector<PixelRect> middle;  ///< of the pupil
        std::vector<PixelRect> pupil;   ///< edge and middle
    };
    /// What lies beyond the limbus, and the iris with what lies over it, as light before instruments and lamp: kept as
    /// long as neither the microscope nor the front of the eye changes.
    struct KeptLight {
        ProgramVariants write_white;
        ProgramVariants write_iris;
        std::array<ProgramVariants, 3> draw;  ///< beyond the limbus, iris, pupil
        Target light;                         ///< iris and its share; what lies over it
        PupilChanges pupil;
        std::vector<unsigned char> parameters;  ///< of what is written, or would be
        std::vector<unsigned char> now;         ///< of this picture
        bool is_written = false;
        double time_s = 0.0;   ///< of the picture before
        std::size_t turn = 0;  ///< counts pictures: which of the iris's bands are painted anew for the tear film
    };
    /// What a picture is drawn of.
    struct Seen {
        const Frame& frame;
        const View& outer;
        const View& inner;
        const DepthPass& depth;
        const Texture& detail;
    };
    static Result<KeptLight> make_kept_light(int width, int height);
    MicroscopeView(Steps steps, std::array<ProgramVariants, 4> parts, std::optional<KeptLight> kept, EyePainter painter,
                   LensFront front, SheetLayer sheets, CrackLayer cracks, int width, int height);
    bool is_still(const Seen& seen, double stop_pixels);
    static Regions regions_of(const Frame& frame, const View& outer, const View& inner, double stop_pixels);
    void write_kept_light(const Regions& where, const Seen& seen);
    void draw_kept(const Regions& where, const Seen& seen, const PixelRect& pupil, PassClock& clock);
    void log_fundus();
    void find_changes_of_pupil(unsigned features, const Seen& seen, const PixelRect& pupil, TileMask& stale);
    void draw_anew(const Regions& where, const Seen& seen, PassClock& clock);
    void find_instruments(const View& inner);
    void draw_part(const std::vector<PixelRect>& where);
    void gather_light(const Frame& frame, const View& inner, const DepthPass& depth);
    void soften(const View& inner, const DepthPass& depth, const PixelRect& area);
    void cast_shadows(const View& inner);
    void compose(const Program& program, const Seen& seen) const;
    /// The rest of what a program is told: what is another thing in every picture.
    static void set_moving(const Program& program, const Frame& frame);

    Steps steps_;
    std::array<ProgramVariants, 4> parts_;  ///< see microscope.frag
    std::optional<KeptLight> kept_;         ///< none: each picture is drawn anew
    EyePainter eye_painter_;
    LensFront front_;
    SheetLayer sheets_;
    CrackLayer cracks_;
    ToolLayer inside_;
    ToolLayer outside_;
    Target light_;    ///< one pixel
    Target across_;   ///< optical depth softened sideways, half size
    Target soft_;     ///< and upwards
    Target shadows_;  ///< an eighth of the size
    Target picture_;
    TileMask tools_;            ///< where instruments are
    TileMask shaded_;           ///< where their shadows may be
    TileMask disturbed_;        ///< where instruments or their shadows are, or were in the picture before
    TileMask painted_;          ///< what of the picture is new
    double stop_pixels_ = 0.0;  ///< radius of the field in the picture before
    VertexStream rectangles_;
    std::optional<EyeTextures> textures_;
    PaintedFor painted_for_;
};

}  // namespace rhexis

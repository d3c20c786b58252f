// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/microscope_view.hpp"

#include <algorithm>

#include "render/eye_parameters.hpp"
#include "render/still_lens.hpp"

namespace rhexis {

namespace {

constexpr std::array part_names{"beyond the limbus", "iris", "edge of the pupil", "middle of the pupil"};

constexpr double softening_mm = 0.10;  ///< standard deviation: tissue scatters, and facets should not show
constexpr double beyond_mm = 0.22;     ///< as far smoothing and the shadows of sheets reach beyond the pupil,
constexpr int area_margin = 4;         ///< [pixels] and so much more

constexpr double sheet_margin = 0.6;  ///< beyond the pupil's edge that sheets are drawn [mm]

/// How far from an instrument its shadow falls. [mm]
constexpr int shadow_scale = 8;  ///< they are drawn at an eighth of the size
const Vec2 inner_shadow(0.28, -0.25);
const Vec2 outer_shadow(0.45, -0.45);

/// Where the shadow of what lies in a rectangle can show: see shadows.frag.
PixelRect shadow_of(const PixelRect& rect, const Vec2& shift_mm, const View& view) {
    constexpr double farthest = 1.5;  // of the shift
    constexpr double coarse = 1.5 * shadow_scale;
    const double mm = 1.0 / pixel_mm(view, Vec3::Zero());
    const Vec2 shift = mm * shift_mm;
    const double soft = std::abs(shift.y()) * std::max(1.0, double(view.width) / view.height) + coarse;
    const int left = static_cast<int>(std::floor(rect.x + shift.x() - soft));
    const int right = static_cast<int>(std::ceil(rect.x + rect.width + farthest * shift.x() + soft));
    const int low = static_cast<int>(std::floor(rect.y + farthest * shift.y() - soft));
    const int high = static_cast<int>(std::ceil(rect.y + rect.height + shift.y() + soft));
    return {left, low, right - left, high - low};
}

constexpr double film_jump_s = 0.25;          ///< of time, beyond which the tear film is drawn anew at once
constexpr float pupil_grain = 1.0F / 256.0F;  ///< [mm, and what has no unit]: changes that are not seen
constexpr std::size_t film_turns = 8;         ///< pictures, until all of it is

/// Centre of the pupil and its reach sideways and upwards, in pixels from the bottom left.
struct PupilOnScreen {
    Vec2 centre;
    Vec2 reach;
};

/// How near to the axis a wound shows. [mm]
double reach_of_wound(const EyeAnatomy& eye, const Vec3& inner_lip, double width) {
    return width > 0.0 ? 1.075 * inner_lip.head<2>().norm() - 0.35 : eye.limbus_radius;
}

/// Within this, at the iris, neither its edge nor a wound nor the limbus can show. [mm]
double core_radius(const Frame& frame) {
    const EyeAnatomy& eye = *frame.eye;
    const double magnified = 1.15;  // by the cornea, at most
    const double wound = std::min(reach_of_wound(eye, eye.incision, eye.incision_width),
                                  reach_of_wound(eye, eye.side_port, eye.side_port_width));
    const double clear = std::min(wound - flap_of(frame), eye.limbus_radius - 1.5) / magnified;
    return std::max(0.0, std::min(opening_of(eye) - 0.25 - std::abs(caught_edge(frame).z()), clear));
}

PupilOnScreen pupil_on_screen(const EyeAnatomy& eye, const View& inner) {
    const Vec3 middle(0.0, 0.0, eye.iris_z);
    PupilOnScreen pupil{pixel_of(inner, middle), Vec2::Zero()};
    const double radius = opening_of(eye);
    for (const Vec3& rim : {Vec3(radius, 0.0, 0.0), Vec3(0.0, radius, 0.0)}) {
        pupil.reach += (pixel_of(inner, middle + rim) - pupil.centre).cwiseAbs();
    }
    pupil.centre.y() = inner.height - pupil.centre.y();
    return pupil;
}

/// Where the coaxial light is half as bright as in the middle of its spot: a third wider than the cornea, as pictures
/// of operations have it, and as wide as the field where that is wider, as a lamp's field stop is opened. Proposals. It
/// goes with the microscope.
double half_of_spot(const View& view) {
    constexpr double least_mm = 7.75;
    constexpr double of_field = 0.51;
    return std::max(least_mm, of_field * view.height * pixel_mm(view, view.plane_point));
}

/// What comes back from the fundus fades beside the middle of the spot, as a bell. Proposal.
double lamp_share(const View& view) {
    const double beside = view.plane_point.head<2>().norm();
    return std::exp2(-(beside * beside) / (half_of_spot(view) * half_of_spot(view)));
}

void set_lamp(const Program& program, const View& outer) {
    program.set("lamp_spot", Vec3(outer.plane_point.x(), outer.plane_point.y(), half_of_spot(outer)));
}

/// Of what is compared with the picture before.
template <typename Value>
void append_bytes(const Value& value, std::vector<unsigned char>& bytes) {
    const auto* first = reinterpret_cast<const unsigned char*>(&value);
    bytes.insert(bytes.end(), first, first + sizeof value);
}

/// As far as what is changed there changes what is softened.
PixelRect reached(const PixelRect& changed, const View& view) {
    constexpr double deviations = 2.5;
    const int reach = area_margin + static_cast<int>(deviations * softening_mm / pixel_mm(view, Vec3::Zero()));
    return changed.empty()
               ? changed
               : PixelRect{changed.x - reach, changed.y - reach, changed.width + 2 * reach, changed.height + 2 * reach};
}

Result<ProgramVariants> build_part(int part) {
    return ProgramVariants::create(
        {"part.vert"},
        {"view.glsl", "lamp.glsl", "eye_front.glsl", "bag_support.glsl", "pupil_contents.glsl", "microscope.frag"},
        feature_names(), "#define PART " + std::to_string(part) + "\n");
}

}  // namespace

EyeAreas eye_areas(const EyeAnatomy& eye, const View& outer, const View& inner) {
    EyeAreas areas;
    areas.cornea = united(rect_around_circle(outer, eye.limbus_radius + 0.5, eye.limbus_z, 2),
                          rect_around_circle(outer, 0.5 * eye.limbus_radius, eye.cornea_apex_z, 2));
    const int margin = area_margin + static_cast<int>(beyond_mm / pixel_mm(inner, Vec3(0.0, 0.0, eye.iris_z)));
    areas.pupil = rect_around_circle(inner, opening_of(eye) + 0.05, eye.iris_z, margin);
    // The pupil's part draws everything that the cornea's does, so it may reach beyond.
    areas.cornea = united(areas.cornea, areas.pupil);
    return areas;
}

Result<MicroscopeView::KeptLight> MicroscopeView::make_kept_light(int width, int height) {
    Result<ProgramVariants> write_white = build_part(4);
    Result<ProgramVariants> write_iris = build_part(5);
    Result<ProgramVariants> draw_white = build_part(6);
    Result<ProgramVariants> draw_iris = build_part(7);
    Result<ProgramVariants> draw_pupil = build_part(8);
    for (const Result<ProgramVariants>* program : {&write_white, &write_iris, &draw_white, &draw_iris, &draw_pupil}) {
        if (!program->ok()) {
            return program->error();
        }
    }
    return KeptLight{std::move(write_white).value(),
                     std::move(write_iris).value(),
                     {std::move(draw_white).value(), std::move(draw_iris).value(), std::move(draw_pupil).value()},
                     make_double_target(width, height, GL_RGBA16F, GL_NEAREST),
                     PupilChanges(width, height),
                     {},
                     {}};
}

Result<MicroscopeView> MicroscopeView::create(int width, int height, bool keeps_light) {
    Result<Program> light = Program::build({"fullscreen.vert"}, {"view.glsl", "pupil_light.frag"});
    Result<Program> soften = Program::build({"fullscreen.vert"}, {"soften.frag"});
    Result<Program> shadows = Program::build({"part.vert"}, {"shadows.frag"});
    Result<Program> card = Program::build({"fullscreen.vert"}, {"view.glsl", "lamp.glsl", "card.frag"});
    for (const Result<Program>* program : {&light, &soften, &shadows, &card}) {
        if (!program->ok()) {
            return program->error();
        }
    }
    Result<ProgramVariants> white = build_part(0);
    Result<ProgramVariants> iris = build_part(1);
    Result<ProgramVariants> edge = build_part(2);
    Result<ProgramVariants> middle = build_part(3);
    for (const Result<ProgramVariants>* program : {&white, &iris, &edge, &middle}) {
        if (!program->ok()) {
            return program->error();
        }
    }
    Result<EyePainter> painter = EyePainter::create();
    if (!painter.ok()) {
        return painter.error();
    }
    Result<LensFront> front = LensFront::create(width, height, keeps_light);
    if (!front.ok()) {
        return front.error();
    }
    Result<SheetLayer> sheets = SheetLayer::create(width, height);
    if (!sheets.ok()) {
        return sheets.error();
    }
    Result<CrackLayer> cracks = CrackLayer::create(width, height);
    if (!cracks.ok()) {
        return cracks.error();
    }
    std::optional<KeptLight> kept;
    if (keeps_light) {
        Result<KeptLight> made = make_kept_light(width, height);
        if (!made.ok()) {
            return made.error();
        }
        kept.emplace(std::move(made).value());
    }
    return MicroscopeView(
        Steps{std::move(light).value(), std::move(soften).value(), std::move(shadows).value(), std::move(card).value()},
        std::array<ProgramVariants, 4>{std::move(white).value(), std::move(iris).value(), std::move(edge).value(),
                                       std::move(middle).value()},
        std::move(kept), std::move(painter).value(), std::move(front).value(), std::move(sheets).value(),
        std::move(cracks).value(), width, height);
}

MicroscopeView::MicroscopeView(Steps steps, std::array<ProgramVariants, 4> parts, std::optional<KeptLight> kept,
                               EyePainter painter, LensFront front, SheetLayer sheets, CrackLayer cracks, int width,
                               int height)
    : steps_(std::move(steps)),
      parts_(std::move(parts)),
      kept_(std::move(kept)),
      eye_painter_(std::move(painter)),
      front_(std::move(front)),
      sheets_(std::move(sheets)),
      cracks_(std::move(cracks)),
      inside_(width, height),
      outside_(width, height),
      light_(make_single_target(1, 1, GL_RGBA32F, GL_NEAREST)),
      across_(make_single_target((width + 1) / 2, (height + 1) / 2, GL_RGBA16F, GL_NEAREST)),
      soft_(make_single_target((width + 1) / 2, (height + 1) / 2, GL_RGBA16F, GL_LINEAR)),
      shadows_(make_single_target((width + shadow_scale - 1) / shadow_scale, (height + shadow_scale - 1) / shadow_scale,
                                  GL_RGBA8, GL_LINEAR)),
      picture_(make_single_target(width, height, GL_RGBA16F, GL_LINEAR_MIPMAP_LINEAR)),
      tools_(width, height),
      shaded_(width, height),
      disturbed_(width, height),
      painted_(width, height),
      rectangles_({2}) {
    glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
    // Beyond the field's stop and where no instrument is nothing is painted, and it must be some light, not any bits.
    for (const Target* target : {&picture_, &shadows_}) {
        target->bind();
        glClear(GL_COLOR_BUFFER_BIT);
    }
}

void MicroscopeView::draw(ToolPainter& painter, const Frame& frame, const std::vector<ToolMesh>& tools,
                          const View& outer, const View& inner, const DepthPass& depth, const Texture& detail,
                          double stop_pixels, PassClock& clock) {
    const EyeAnatomy& eye = *frame.eye;
    const PaintedFor wanted{eye.limbus_radius, eye.has_iris, eye.has_cornea};
    if (!textures_ || painted_for_ != wanted) {
        textures_.emplace(eye_painter_.paint(eye));
        painted_for_ = wanted;
    }
    const EyeAreas areas = eye_areas(eye, outer, inner);
    front_.draw(frame, inner, depth.reference(), areas.pupil);
    clock.end("first surface of the lens");
    if (has_sheets(frame)) {
        sheets_.draw(frame, inner, depth.stop(), depth.reference(), contour_of(still_lens(frame)), detail, areas.pupil,
                     opening_of(eye) + sheet_margin);
        clock.end("sheets");
    }
    if (has_cracks(frame)) {
        cracks_.draw(frame, inner, depth.stop(), depth.reference(), areas.pupil);
        clock.end("cracks");
    }
    inside_.draw(painter, frame, tools, inner, Medium::inside, areas.cornea, eye, detail);
    clock.end("instruments inside");
    outside_.draw(painter, frame, tools, outer, Medium::outside, whole(outer), eye, detail);
    clock.end("instruments outside");
    gather_light(frame, inner, depth);
    clock.end("light of the pupil");
    soften(inner, depth, kept_ ? intersected(areas.pupil, reached(depth.changed(), inner)) : areas.pupil);
    clock.end("softened depth");
    find_instruments(inner);
    cast_shadows(inner);
    clock.end("shadows");
    const Regions where = regions_of(frame, outer, inner, stop_pixels);
    const Seen seen{frame, outer, inner, depth, detail};
    const bool still = kept_ && is_still(seen, stop_pixels);
    if (still && !kept_->is_written) {
        write_kept_light(where, seen);
        kept_->pupil.forget();
        clock.end("light that is kept");
    }
    picture_.bind();
    if (stop_pixels_ != stop_pixels) {  // what spreads looks a little beyond the stop
        glClear(GL_COLOR_BUFFER_BIT);
        stop_pixels_ = stop_pixels;
    }
    if (still) {
        draw_kept(where, seen, areas.pupil, clock);
    } else {
        draw_anew(where, seen, clock);
    }
    if (kept_) {
        kept_->is_written = still;
        kept_->time_s = frame.time_s;
    }
}

MicroscopeView::Regions MicroscopeView::regions_of(const Frame& frame, const View& outer, const View& inner,
                                                   double stop_pixels) {
    const EyeAnatomy& eye = *frame.eye;
    const std::vector<PixelRect> cornea = bands_around_circle(outer, eye.limbus_radius + 0.4, eye.limbus_z, 2);
    const std::vector<PixelRect> pupil = bands_around_circle(inner, opening_of(eye) + 0.05, eye.iris_z, 2);
    const std::vector<PixelRect> middle = bands_within_circle(inner, core_radius(frame), eye.iris_z);
    Regions where{without(without(bands_of(inner), cornea), pupil), without(cornea, pupil), without(pupil, middle),
                  middle, pupil};
    for (std::vector<PixelRect>* part : {&where.white, &where.iris, &where.edge, &where.middle, &where.pupil}) {
        *part = within_stop(std::move(*part), inner, stop_pixels);
    }
    return where;
}

/// Tiles of instruments and of their shadows, now and in the picture before.
void MicroscopeView::find_instruments(const View& inner) {
    disturbed_ = shaded_;
    tools_.clear();
    shaded_.clear();
    for (const auto& [layer, shift] : {std::pair(&inside_, inner_shadow), std::pair(&outside_, outer_shadow)}) {
        disturbed_.mark(layer->stale().rects());
        for (const PixelRect& rect : layer->covered().rects()) {
            tools_.mark(rect);
            shaded_.mark(shadow_of(rect, shift, inner));
        }
    }
    disturbed_.mark(shaded_.rects());
}

void MicroscopeView::draw_anew(const Regions& where, const Seen& seen, PassClock& clock) {
    const std::array<const std::vector<PixelRect>*, 4> bands{&where.white, &where.iris, &where.edge, &where.middle};
    for (std::size_t part = 0; part < bands.size(); ++part) {
        const Program& program = parts_[part].with(features_of(seen.frame, part >= 2));
        compose(program, seen);
        set_moving(program, seen.frame);
        draw_part(*bands[part]);
        clock.end(part_names[part]);
    }
    painted_.mark_all();
}

void MicroscopeView::write_kept_light(const Regions& where, const Seen& seen) {
    const unsigned front = features_of(seen.frame, false);
    kept_->light.bind();
    compose(kept_->write_white.with(front), seen);
    draw_part(where.white);
    compose(kept_->write_iris.with(front), seen);
    draw_part(where.iris);
    draw_part(where.pupil);
}

/// How much light reaches the fundus, in steps that are not seen.
void MicroscopeView::log_fundus() {
    constexpr float steps = 100.0F;
    std::array<float, 4> reaches{};
    light_.bind();
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_FLOAT, reaches.data());
    for (float& share : reaches) {
        share = std::round(steps * share);
    }
    append_bytes(reaches, kept_->now);
}

/// Only what has changed, what instruments change, and some bands of iris and pupil at a time, over which the tear film
/// runs, and where the light of the fundus gets stronger.
void MicroscopeView::draw_kept(const Regions& where, const Seen& seen, const PixelRect& pupil, PassClock& clock) {
    TileMask stale = disturbed_;
    const bool film_jumps = std::abs(seen.frame.time_s - kept_->time_s) > film_jump_s;
    for (const std::vector<PixelRect>* part : {&where.iris, &where.pupil}) {
        for (const PixelRect& band : *part) {
            if (film_jumps || (band.y / band_rows + kept_->turn) % film_turns == 0) {
                stale.mark(band);
            }
        }
    }
    ++kept_->turn;
    painted_.clear();
    const auto draw = [&](std::size_t part, unsigned features, const std::vector<PixelRect>& rects) {
        const Program& program = kept_->draw[part].with(features);
        compose(program, seen);
        set_moving(program, seen.frame);
        program.set("kept", kept_->light.colours[0], 7);  // units of what these parts do not look up
        program.set("kept_added", kept_->light.colours[1], 8);
        draw_part(rects);
        painted_.mark(rects);
    };
    const unsigned front = features_of(seen.frame, false);
    draw(0, front, stale.within(where.white));
    clock.end("beyond the limbus");
    draw(1, front, stale.within(where.iris));
    clock.end("iris");
    const unsigned all = features_of(seen.frame, true);
    find_changes_of_pupil(all, seen, pupil, stale);
    picture_.bind();
    const TileMask& crumbs = kept_->pupil.crumbs();
    draw(2, all & ~crumb_feature(), stale.without(crumbs).within(where.pupil));
    if ((all & crumb_feature()) != 0) {
        draw(2, all, crumbs.within(stale.within(where.pupil)));
    }
    clock.end("pupil");
}

/// Marks them. What is told of the scene is compared as its program is told it.
void MicroscopeView::find_changes_of_pupil(unsigned features, const Seen& seen, const PixelRect& pupil,
                                           TileMask& stale) {
    kept_->now.clear();
    append_bytes(features, kept_->now);
    Program& program = kept_->draw[2].with(features);
    program.log_to(&kept_->now, pupil_grain);
    compose(program, seen);
    program.log_to(nullptr);
    log_fundus();
    stale.mark(kept_->pupil.find(seen.depth.raster(), seen.frame, seen.inner, pupil, kept_->now).rects());
    if (has_sheets(seen.frame) || has_cracks(seen.frame)) {
        stale.mark(pupil);  // which are drawn anew each time
    }
}

/// Whether the front of the eye is seen as in the picture before.
bool MicroscopeView::is_still(const Seen& seen, double stop_pixels) {
    const unsigned features = features_of(seen.frame, false);
    kept_->now.clear();
    append_bytes(stop_pixels, kept_->now);
    append_bytes(features, kept_->now);
    for (ProgramVariants* variants : {&kept_->write_white, &kept_->write_iris}) {
        Program& program = variants->with(features);
        program.log_to(&kept_->now);
        compose(program, seen);
        program.log_to(nullptr);
    }
    const bool same = kept_->now == kept_->parameters;
    kept_->parameters.swap(kept_->now);
    return same;
}

/// With the program in use.
void MicroscopeView::draw_part(const std::vector<PixelRect>& where) {
    if (!where.empty()) {
        rectangles_.send(triangles_of(where, picture_.width, picture_.height));
        rectangles_.draw();
    }
}

void MicroscopeView::draw_card(double reflectance, const EyeAnatomy& eye, const View& outer) {
    if (kept_) {
        kept_->parameters.clear();  // of a picture that is no more
        kept_->is_written = false;
    }
    painted_.mark_all();
    picture_.bind();
    steps_.card.use();
    set_view(steps_.card, outer);
    set_lamp(steps_.card, outer);
    steps_.card.set("limbus_z", eye.limbus_z);
    steps_.card.set("reflectance", reflectance);
    cover_target();
}

void MicroscopeView::gather_light(const Frame& frame, const View& inner, const DepthPass& depth) {
    const PupilOnScreen pupil = pupil_on_screen(*frame.eye, inner);
    const Program& program = steps_.light;
    light_.bind();
    program.use();
    set_view(program, inner);
    program.set("optical_depth", depth.optical_depth(), 0);
    program.set("stop", depth.stop(), 1);
    program.set("extinction_tint", depth.tint());
    program.set("pupil_centre", pupil.centre);
    program.set("pupil_reach", pupil.reach);
    cover_target();
}

void MicroscopeView::soften(const View& inner, const DepthPass& depth, const PixelRect& area) {
    if (area.empty()) {
        return;
    }
    const double pixels = softening_mm / pixel_mm(inner, depth.reference());
    const Program& program = steps_.soften;
    const Scissor scissor(halved(area));
    program.use();
    program.set("stop", depth.stop(), 1);
    across_.bind();
    program.set("source", depth.optical_depth(), 0);
    program.set("direction", Vec2(pixels / inner.width, 0.0));
    cover_target();
    soft_.bind();
    program.set("source", across_.colours[0], 0);
    program.set("direction", Vec2(0.0, pixels / inner.height));
    cover_target();
}

/// The lamp stands a little to the left and above: shadows fall to the right and below, further on what lies deeper.
void MicroscopeView::cast_shadows(const View& inner) {
    // They reach as far as what is disturbed: beyond that the picture before had none either.
    std::vector<PixelRect> where;
    for (const PixelRect& rect : disturbed_.rects()) {
        where.push_back({rect.x / shadow_scale, rect.y / shadow_scale, (rect.width + shadow_scale - 1) / shadow_scale,
                         (rect.height + shadow_scale - 1) / shadow_scale});
    }
    if (where.empty()) {
        return;
    }
    const double mm = 1.0 / pixel_mm(inner, Vec3::Zero());
    const Vec2 one_mm(mm / inner.width, mm / inner.height);
    const Program& program = steps_.shadows;
    shadows_.bind();
    program.use();
    program.set("inner_tools", inside_.picture(), 0);
    program.set("outer_tools", outside_.picture(), 1);
    program.set("inner_shift", Vec2(one_mm.cwiseProduct(inner_shadow)));
    program.set("outer_shift", Vec2(one_mm.cwiseProduct(outer_shadow)));
    rectangles_.send(triangles_of(where, shadows_.width, shadows_.height));
    rectangles_.draw();
}

void MicroscopeView::compose(const Program& program, const Seen& seen) const {
    program.use();
    set_view(program, seen.inner);
    program.set("optical_depth", seen.depth.optical_depth(), 0);
    program.set("stop", seen.depth.stop(), 1);
    program.set("front", front_.surface(), 2);
    program.set("relief", front_.relief(), 3);
    program.set("inner_tools", inside_.picture(), 4);
    program.set("outer_tools", outside_.picture(), 5);
    program.set("pupil_light", light_.colours[0], 6);
    program.set("iris_map", textures_->iris, 7);
    program.set("sclera_map", textures_->sclera, 8);
    program.set("sclera_relief", textures_->relief, 9);
    program.set("detail_map", seen.detail, 10);
    program.set("soft_depth", soft_.colours[0], 11);
    program.set("shadows", shadows_.colours[0], 12);
    program.set("sheets", sheets_.picture(), 13);
    program.set("cracks", cracks_.picture(), 14);
    program.set("trypan_blue", seen.frame.eye->trypan_blue);
    program.set("extinction_tint", seen.depth.tint());
    program.set("lamp_share", lamp_share(seen.outer));
    set_lamp(program, seen.outer);
    program.set("reference", seen.depth.reference());
    program.set("pixel_mm", pixel_mm(seen.inner, Vec3(0.0, 0.0, seen.frame.eye->iris_z)));
    set_anatomy(program, *seen.frame.eye);
    program.set("cortical_opacity", seen.frame.eye->cortical_opacity);
    set_bag(program, seen.frame);
    set_harm(program, seen.frame);
}

void MicroscopeView::set_moving(const Program& program, const Frame& frame) {
    program.set("time_s", frame.time_s);
    set_crumbs(program, frame);
}

}  // namespace rhexis

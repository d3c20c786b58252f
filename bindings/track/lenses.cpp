// SPDX-License-Identifier: GPL-3.0-or-later
// rhexis track lenses: what each camera's lens does, by a board.
#include <cstdio>

#include "base/output_file.hpp"
#include "track/commands.hpp"
#include "track/page.hpp"
#include "tracking/calibration/calibration_report.hpp"
#include "tracking/calibration/rig_lenses.hpp"
#include "trial/progress.hpp"

namespace rhexis::tracking {
namespace {

/// Passes images on, and keeps them in a folder where there is one.
class KeptFrames final : public FrameSource {
public:
    KeptFrames(std::unique_ptr<FrameSource> source, const Rig& rig, const std::string& folder)
        : source_(std::move(source)), rig_(rig), folder_(folder) {}

    Result<bool> next(FrameSet& set) override {
        Result<bool> more = source_->next(set);
        if (more && more.value() && !folder_.empty()) {
            if (const Status kept = keep_frames(folder_, rig_, set, count_++); !kept) {
                return kept.error();
            }
        }
        return more;
    }
    [[nodiscard]] double rate_hz() const override { return source_->rate_hz(); }

private:
    std::unique_ptr<FrameSource> source_;
    const Rig& rig_;
    const std::string& folder_;
    std::uint64_t count_ = 0;
};

Result<std::vector<SeenBoards>> look(const Setup& setup, const BoardsPlan& plan, const std::string& keep) {
    Result<std::unique_ptr<FrameSource>> source = open_boards(setup, plan.board, plan.views);
    if (!source) {
        return source.error();
    }
    KeptFrames kept(std::move(source).value(), setup.rig, keep);
    Progress progress("lenses");
    return look_for_boards(kept, setup.rig, plan, [&progress](double share) {
        progress.show(share, "show the board to each camera, slanted to all sides, up to the rims");
    });
}

std::string names_of(const std::vector<std::string>& names) {
    constexpr std::size_t most = 3;
    std::string text;
    for (std::size_t i = 0; i < std::min(most, names.size()); ++i) {
        text += (i == 0 ? "" : ", ") + names[i];
    }
    return names.size() > most ? text + " and " + std::to_string(names.size() - most) + " more" : text;
}

void print_lens(const RigLenses& lenses, std::size_t camera) {
    const LensFigures& lens = lenses.rig.lenses[camera];
    const SeenBoards& seen = lenses.seen[camera];
    std::printf("%s: residual %.3f pixels, focal length %.2f +- %.2f pixels, %.0f %% of the image, %d views",
                lenses.rig.cameras[camera].name.c_str(), lens.residual_px, lenses.rig.cameras[camera].lens.fx,
                lens.focal_sigma_px, 100.0 * lens.coverage.share(), lens.views);
    if (lens.left_out > 0) {
        std::printf(", %d that did not fit", lens.left_out);
    }
    if (seen.alike > 0) {
        std::printf(", %d like the one before", seen.alike);
    }
    if (!seen.without.empty()) {
        std::printf(", %zu images without the board: %s", seen.without.size(), names_of(seen.without).c_str());
    }
    std::printf("\n");
}

}  // namespace

Status lenses(const LensesOptions& options) {
    BoardsPlan plan;
    plan.views = options.views;
    plan.seconds = options.seconds;
    const Result<GridPlan> board = parse_board(options.board);
    if (!board) {
        return board.error();
    }
    plan.board = board.value();
    Result<Setup> setup = read_setup(options.setup);
    if (!setup) {
        return setup.error();
    }
    if (!options.images.empty()) {
        setup.value().source = FolderPlan{options.images};
    }
    Result<std::vector<SeenBoards>> seen = look(setup.value(), plan, options.keep);
    if (!seen) {
        return seen.error();
    }
    const Result<RigLenses> found = calibrate_lenses(setup.value().rig, std::move(seen).value(), plan);
    if (!found) {
        return found.error();
    }
    const std::string rig = options.rig.empty() ? setup.value().rig_path : options.rig;
    const std::string page = page_beside(rig, options.page);
    if (const Status written = write_rig(found.value().rig, rig); !written) {
        return written;
    }
    if (const Status written = write_file(page, lens_page(setup.value().rig_path, found.value().rig)); !written) {
        return written;
    }
    for (std::size_t i = 0; i < found.value().rig.cameras.size(); ++i) {
        print_lens(found.value(), i);
    }
    for (const std::string& advice : lens_advice(found.value().rig)) {
        std::printf("  %s\n", advice.c_str());
    }
    std::printf("%s: next, rhexis track calibrate %s\n%s\n", rig.c_str(), options.setup.c_str(), page.c_str());
    return success();
}

}  // namespace rhexis::tracking

// SPDX-License-Identifier: GPL-3.0-or-later
// rhexis fold: an implant folded into the cartridge of an injector, as a state from which runs begin.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>

#include "base/index.hpp"
#include "base/numbers.hpp"
#include "cli/command.hpp"
#include "render/image_file.hpp"
#include "render/renderer.hpp"
#include "session/implant_fold.hpp"
#include "trial/places.hpp"
#include "trial/progress.hpp"

namespace rhexis::cli {
namespace {

constexpr const char* fold_help =
    "Forceps tuck the haptics onto the optic, the wings of the cartridge roll the lens round them and close to the\n"
    "bore. What is printed: energy in the lens's springs, deepest penetration of the stage over thickness, steps that\n"
    "did not balance. Takes a minute or two.\n"
    "\n"
    "  rhexis fold --out lens.rhxs --pictures folding\n"
    "  rhexis fold --out thin.rhxs --set implant.centre_mm=0.4 --set cartridge.bore_mm=2.2\n"
    "\n"
    "Settings: cartridge.bore_mm, cartridge.nozzle_mm, cartridge.friction, cartridge.tucked, cartridge.inverted,\n"
    "implant.centre_mm, implant.edge_mm, implant.haptic_mm, implant.modulus_mpa, implant.tackiness_kpa,\n"
    "implant.triangles (docs/implant.md).";

struct FoldArguments {
    std::string out;
    std::string pictures;
    std::vector<std::string> set;
};

std::optional<double> number_in(const std::string& text) {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    return text.empty() || *end != '\0' ? std::nullopt : std::optional<double>(value);
}

/// KEY=NUMBER of implant or cartridge. A nozzle that nobody names is as wide as the bore.
Result<std::map<std::string, double>> fold_settings(const std::vector<std::string>& pairs) {
    std::map<std::string, double> settings;
    for (const std::string& pair : pairs) {
        const Result<std::pair<std::string, std::string>> one = key_and_value(pair, "fold", "cartridge.bore_mm=2.6");
        if (!one) {
            return one.error();
        }
        const auto& [name, text] = one.value();
        const std::optional<double> value = number_in(text);
        if (!value || !(name.starts_with("implant.") || name.starts_with("cartridge."))) {
            return Error{std::string("--set ").append(pair).append(" is no setting of implant or cartridge"), "fold",
                         "--set key=number, as in --set cartridge.bore_mm=2.6"};
        }
        settings[name] = *value;
    }
    if (settings.contains("cartridge.bore_mm") && !settings.contains("cartridge.nozzle_mm")) {
        settings["cartridge.nozzle_mm"] = settings["cartridge.bore_mm"];
    }
    return settings;
}

/// From the front, to the right and above.
Camera camera() {
    Camera camera;
    camera.eye = Vec3(14.0, -42.0, 36.0);
    camera.target = Vec3(0.0, 0.0, 0.8);
    camera.up = Vec3::UnitZ();
    camera.field_mm = 11.5;
    return camera;
}

class Album {
public:
    static Result<Album> create(const std::string& folder) {
        if (Status status = prepare_folder(folder); !status) {
            return status.error();
        }
        Result<Renderer> renderer = Renderer::create(640, 480);
        return renderer ? Result<Album>(Album(folder, std::move(renderer).value())) : Result<Album>(renderer.error());
    }

    Status keep(const ImplantFold& fold, std::string name) {
        std::replace(name.begin(), name.end(), ' ', '-');
        char number[16];
        std::snprintf(number, sizeof number, "%02d-", ++count_);
        return write_png(renderer_.draw(fold.frame(), camera()), folder_ + "/" + number + name + ".png");
    }

private:
    Album(std::string folder, Renderer renderer) : folder_(std::move(folder)), renderer_(std::move(renderer)) {}

    std::string folder_;
    Renderer renderer_;
    int count_ = 0;
};

void print(const char* stage, const FoldProgress& now) {
    std::printf("%-20s %5.1f s  energy %6.1f uJ (relaxing %.1f, contact %.1f)  deepest %4.1f %%  unbalanced steps %d\n",
                stage, now.time, 1e-3 * (now.elastic + now.branch + now.kinetic), 1e-3 * now.branch, 1e-3 * now.contact,
                100.0 * now.deepest, now.rough);
    std::fflush(stdout);
}

/// To the end, with a line and two pictures of every stage: half way and at its end.
Status run(ImplantFold& fold, Album* album) {
    Progress progress("fold");
    Status status = album != nullptr ? album->keep(fold, "flat") : success();
    double half = 0.0;
    double time = 0.0;
    while (status && !fold.done()) {
        const FoldProgress before = fold.progress();
        const FoldingStage& stage = folding_stages()[at(before.stage)];
        if (status = fold.step(); !status) {
            break;
        }
        const FoldProgress now = fold.progress();
        progress.show(now.share, stage.name);
        if (now.stage != before.stage) {
            progress.clear();
            print(stage.name, now);
            time = now.time;
        }
        const bool middle = half < time + 0.5 * stage.duration && now.time >= time + 0.5 * stage.duration;
        half = middle ? now.time : half;
        if (album != nullptr && (middle || now.stage != before.stage)) {
            status = album->keep(fold, middle ? std::string("to ").append(stage.name) : stage.name);
        }
    }
    return status;
}

int fold(const FoldArguments& given) {
    const Result<std::map<std::string, double>> settings = fold_settings(given.set);
    if (!settings) {
        return complain(settings.error());
    }
    Result<ImplantFold> fold = ImplantFold::create(folding_scene(settings.value()));
    if (!fold) {
        return complain(fold.error());
    }
    const std::string folder = std::filesystem::path(given.out).parent_path().string();
    if (Status status = prepare_folder(folder.empty() ? "." : folder); !status) {
        return complain(status.error());
    }
    std::optional<Album> album;
    if (!given.pictures.empty()) {
        Result<Album> made = Album::create(given.pictures);
        if (!made) {
            return complain(made.error());
        }
        album.emplace(std::move(made).value());
    }
    if (Status status = run(fold.value(), album ? &*album : nullptr); !status) {
        return complain(status.error(), found_failures);
    }
    const Result<PreparedState> result = fold.value().result();
    if (!result) {
        return complain(result.error(), found_failures);
    }
    if (Status status = write_state(given.out, result.value()); !status) {
        return complain(status.error());
    }
    std::printf("%s: %.0f CPU s for %d steps\n", given.out.c_str(), fold.value().progress().cpu_s,
                fold.value().progress().steps);
    return done;
}

}  // namespace

void add_fold(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand("fold", "Fold an implant into a cartridge, as a state to start from");
    command->footer(fold_help);
    auto given = std::make_shared<FoldArguments>();
    command->add_option("--out", given->out, "State file to write (.rhxs)")->required();
    command->add_option("--pictures", given->pictures, "Folder for pictures of the stages");
    command->add_option("--set", given->set, "Change a setting of implant or cartridge (repeatable)")
        ->take_all()
        ->allow_extra_args(false);
    command->callback([given, &context] { context.status = fold(*given); });
}

}  // namespace rhexis::cli

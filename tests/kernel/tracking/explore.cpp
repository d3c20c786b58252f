#include <cstdio>
#include <cstdlib>
#include <string>
#include "tracking/calibration/wand.hpp"
#include "tracking/measure/tip_errors.hpp"
#include "tracking/sources/synthetic_source.hpp"
#include "tracking/synthetic/bodies.hpp"
using namespace rhexis;
using namespace rhexis::tracking;
int main(int argc, char** argv) {
    const bool images = argc > 2 && std::string(argv[2]) == "images";
    const double longest = argc > 3 ? std::atof(argv[3]) : 3.0;
    const std::uint64_t seed = argc > 4 ? std::strtoull(argv[4], nullptr, 10) : 1;
    const bool perfect = argc > 5;
    auto rig = synthetic::SyntheticRig::create(seed).value();
    Rig solver = without_prism(rig);
    if (!perfect) {
        // lenses as a board would give them (prism unknown); poses by the wand
        Rig given = rig.nominal;
        for (std::size_t i = 0; i < given.cameras.size(); ++i) given.cameras[i].lens = solver.cameras[i].lens;
        synthetic::Film film; film.frames = 600; film.seed = seed + 77; film.delivery.rate_hz = 20;
        auto source = film_markers(rig, synthetic::waved_wand(seed), film).value();
        std::vector<WandFrame> frames; std::vector<CameraSpots> exposures;
        while (source->next(exposures).value()) {
            WandFrame frame;
            for (auto& e : exposures) if (e.spots.size() == 3) frame.views.push_back({e.camera, {e.spots[0].at, e.spots[1].at, e.spots[2].at}});
            frames.push_back(frame);
        }
        Wand wand; wand.at_mm.assign(synthetic::wand_mm.begin(), synthetic::wand_mm.end());
        WandSettings ws; ws.refine_lenses = true;
        auto cal = calibrate_wand(given, wand, frames, ws);
        if (!cal) { std::printf("%s\n", cal.error().text().c_str()); return 1; }
        std::printf("calibration: residual %.4f px, scale sigma %.2e, %d frames, %.2f s\n", cal.value().residual_px, cal.value().scale_sigma, cal.value().frames_used, cal.value().seconds);
        solver = cal.value().rig;
    }
    auto bodies = synthetic::standard_bodies();
    auto clip = synthetic::make_clip(argv[1], seed, bodies, rig.nominal);
    if (!clip) { std::printf("%s\n", clip.error().text().c_str()); return 1; }
    ClipPlan plan; plan.images = images; plan.longest_s = longest; plan.seed = seed;
    auto run = track_clip(rig, solver, clip.value(), plan);
    if (!run) { std::printf("%s\n", run.error().text().c_str()); return 1; }
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const auto e = tip_errors(run.value().traces[i]); const auto a = axis_errors(run.value().traces[i]);
        std::printf("%-24s %5ld/%5ld mean %6.1f p95 %6.1f p999 %6.1f max %7.1f um  axis95 %.4f deg  jitter %.2f um  cameras %d\n", bodies[i].name.c_str(), e.valid, e.frames, 1e3*e.mean, 1e3*e.of_95, 1e3*e.of_999, 1e3*e.worst, a.of_95, 1e3*jitter(run.value().traces[i]), run.value().traces[i].back().cameras);
    }
    if (clip.value().name == "tremor") for (double f : {2.0}) { auto r = response(run.value().traces[1], f); std::printf("%g Hz gain %.3f lag %.2f ms\n", f, r.gain, 1e3*r.lag_s); }
    std::vector<double> s = run.value().seconds; std::sort(s.begin(), s.end());
    std::printf("wrong %d; tracker ms p50 %.3f p99 %.3f\n", run.value().wrong, 1e3*s[s.size()/2], 1e3*s[s.size()*99/100]);
}

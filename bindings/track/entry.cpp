// SPDX-License-Identifier: GPL-3.0-or-later
// The functions that the shared object shows.
#include "track/chain.hpp"
#include "track/commands.hpp"

extern "C" {

[[gnu::visibility("default")]] void rhexis_tracking_track(const rhexis::tracking::TrackOptions& options,
                                                          rhexis::Status& status) {
    status = rhexis::tracking::track(options);
}
[[gnu::visibility("default")]] void rhexis_tracking_calibrate(const rhexis::tracking::CalibrateOptions& options,
                                                              rhexis::Status& status) {
    status = rhexis::tracking::calibrate(options);
}
[[gnu::visibility("default")]] void rhexis_tracking_lenses(const rhexis::tracking::LensesOptions& options,
                                                           rhexis::Status& status) {
    status = rhexis::tracking::lenses(options);
}
[[gnu::visibility("default")]] void rhexis_tracking_pivot(const rhexis::tracking::PivotOptions& options,
                                                          rhexis::Status& status) {
    status = rhexis::tracking::pivot(options);
}
[[gnu::visibility("default")]] void rhexis_tracking_measure(const rhexis::tracking::MeasureOptions& options,
                                                            rhexis::Status& status) {
    status = rhexis::tracking::measure(options);
}
[[gnu::visibility("default")]] void rhexis_tracking_begin(const rhexis::tracking::BeginOptions& options,
                                                          rhexis::Status& status) {
    status = rhexis::tracking::begin(options);
}
[[gnu::visibility("default")]] void rhexis_tracking_design(const rhexis::tracking::DesignOptions& options,
                                                           rhexis::Status& status) {
    status = rhexis::tracking::design(options);
}
[[gnu::visibility("default")]] void rhexis_tracking_print(const rhexis::tracking::PrintOptions& options,
                                                          rhexis::Status& status) {
    status = rhexis::tracking::print_body(options);
}

[[gnu::visibility("default")]] void rhexis_tracking_chain(const rhexis::tracking::ChainOptions& options,
                                                          rhexis::Result<std::unique_ptr<rhexis::SampleLink>>& link) {
    rhexis::Result<std::unique_ptr<rhexis::tracking::Chain>> chain = rhexis::tracking::Chain::open(options);
    if (chain) {
        link = std::unique_ptr<rhexis::SampleLink>(std::move(chain).value());
    } else {
        link = chain.error();
    }
}

}  // extern "C"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/bench_explicit.hpp"

#include "bench/methods/matrix_free_product.hpp"
#include "bench/timing.hpp"
#include "eye/make_eye.hpp"

namespace rhexis::bench {
namespace {

SolidModel patient_lens(int tetrahedra) {
    Patient patient;
    patient.tetrahedra = tetrahedra;
    return make_eye(patient).value().lens;
}

nlohmann::json product_row(const std::string& name, const SolidModel& model, const Timing& timing) {
    return {{"name", name},
            {"elements", model.coarse.tets.size()},
            {"nodes", model.coarse.nodes.size()},
            {"us", 1e6 * timing.seconds},
            {"ns_per_element", 1e9 * timing.seconds / static_cast<double>(model.coarse.tets.size())},
            {"spread", timing.spread}};
}

nlohmann::json run_product(const BenchOptions& options) {
    nlohmann::json rows = nlohmann::json::array();
    const std::vector<int> sizes = options.quick ? std::vector<int>{1000} : std::vector<int>{1000, 3000, 12000, 24000};
    for (const int size : sizes) {
        const SolidModel model = patient_lens(size);
        const MatrixFreeProduct product(model, rest_state(model));
        const std::vector<Vec3>& x = model.coarse.nodes;
        std::vector<Vec3> y;
        const Timing timing = time_interleaved({[&] { product.apply(x, y); }}, options.repeats)[0];
        rows.push_back(product_row("product/" + std::to_string(size), model, timing));
    }
    return rows;
}

}  // namespace

std::vector<BenchCase> explicit_cases() {
    return {{"product", "scalar double matrix-free stiffness product of the patient's lens: the unit of the others",
             run_product}};
}

}  // namespace rhexis::bench

// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial/html.hpp"

#include <map>
#include <nlohmann/json.hpp>

#include "base/base64.hpp"
#include "lua/report_script.hpp"
#include "trial/places.hpp"
#include "trial/report_json.hpp"

namespace rhexis {
namespace {

using nlohmann::json;

/// Pictures that the report names and that are still there, as text that a page can hold.
std::map<std::string, std::string> read_images(const json& report, const std::string& folder) {
    std::map<std::string, std::string> images;
    for (const json& picture : report.value("pictures", json::array())) {
        const std::string file = picture.is_object() ? picture.value("file", "") : "";
        const Result<std::string> bytes = read_whole_file(folder + "/" + file);
        if (!file.empty() && bytes) {
            images[file] = base64(bytes.value());
        }
    }
    return images;
}

}  // namespace

Result<std::string> report_page(const std::string& root, const std::string& folder, const json& instead) {
    Result<json> report = read_json_file(folder + "/report.json");
    if (!report) {
        return report.error();
    }
    if (report.value().value("schema", 0) != report_schema) {
        return Error{"the report is not of schema " + std::to_string(report_schema), folder,
                     "a newer or older program made it"};
    }
    report.value().update(instead);
    const Result<json> series = read_json_file(folder + "/series.json");
    if (!series) {
        return series.error();
    }
    return report_html(root, report.value(), series.value(), read_images(report.value(), folder));
}

}  // namespace rhexis

// SPDX-License-Identifier: GPL-3.0-or-later
// measure_pictures [--whole] PICTURE.png...: twelve statistics of each, beside what frames of real operations show. In
// the square inscribed in a round field as high as the picture, or of the whole picture.
#include <cstdio>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "scenes/picture_statistics.hpp"

using namespace rhexis;
using namespace rhexis::testing;

namespace {

Image read_image(const std::string& path) {
    cv::Mat rgb = cv::imread(path, cv::IMREAD_COLOR);
    if (rgb.empty()) {
        return {};
    }
    cv::cvtColor(rgb, rgb, cv::COLOR_BGR2RGB);
    return {rgb.cols, rgb.rows, std::vector<unsigned char>(rgb.data, rgb.data + rgb.total() * 3)};
}

}  // namespace

int main(int count, char** words) {
    bool whole = false;
    std::vector<std::string> paths;
    for (int i = 1; i < count; ++i) {
        const std::string word = words[i];
        if (word == "--whole") {
            whole = true;
        } else {
            paths.push_back(word);
        }
    }
    if (paths.empty()) {
        std::fprintf(stderr, "usage: measure_pictures [--whole] PICTURE.png...\n");
        return 2;
    }
    Statistics mean{};
    int least = static_cast<int>(wanted_statistics.size());
    for (const std::string& path : paths) {
        const Image image = read_image(path);
        if (image.rgb.empty()) {
            std::fprintf(stderr, "measure_pictures: %s is no picture that can be read\n", path.c_str());
            return 2;
        }
        const Statistics values = statistics_of(whole ? image : square_of_field(image));
        const int within = count_within(values);
        least = std::min(least, within);
        const std::string outside = outside_of(values);
        std::printf("%s: %d of %zu%s%s\n", path.c_str(), within, values.size(),
                    outside.empty() ? "" : "; outside: ", outside.c_str());
        for (std::size_t i = 0; i < values.size(); ++i) {
            mean[i] += values[i] / static_cast<double>(paths.size());
        }
    }
    std::printf("mean of %zu: %d of %zu within; fewest in one picture: %d\n", paths.size(), count_within(mean),
                mean.size(), least);
    for (std::size_t i = 0; i < mean.size(); ++i) {
        const Statistic& one = wanted_statistics[i];
        std::printf("  %-20s %8.3g   wanted %g to %g\n", one.name, mean[i], one.least, one.most);
    }
    return count_within(mean) == static_cast<int>(mean.size()) ? 0 : 1;
}

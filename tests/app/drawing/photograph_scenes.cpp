#include "tests/app/drawing/photograph_scenes.hpp"

#include "app/input/prepared_study.hpp"
#include "app/input/study_reading.hpp"
#include "app/study_texts.hpp"
#include "dem/scene/geometry/polygon.hpp"

#include <turbojpeg.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace scenes {
namespace {

constexpr int kColumns = 720, kRows = 720;
constexpr int kHalfMortar = 5; // [pixels]

std::vector<dem::DrawnUnit> rubble_units()
{
    std::string text = study_texts::kSmallWall;
    text.insert(text.find("[wall]\n") + 7, "bond = rubble\nseed = 4\n");
    text.replace(text.find("length = 0.60 m"), 15, "length = 1.00 m");
    text.replace(text.find("courses = 3"), 11, "courses = 8");
    text.replace(text.find("course_height = 0.10 m"), 22, "course_height = 0.125 m");
    return app::prepare(app::read_study(app::parse_study_text("rubble.ini", text)))
        .study.geometry.units;
}

/// Mortar takes a pixel of each border.
void erode(app::Labels& labels)
{
    const app::Labels before = labels;
    for (int row = 0; row < labels.rows; ++row)
        for (int column = 0; column < labels.columns; ++column)
            for (const auto& [c, r] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
                const int x = std::clamp(column + c, 0, kColumns - 1),
                          y = std::clamp(row + r, 0, kRows - 1);
                if (before.at(x, y) != before.at(column, row))
                    labels.label[labels.pixel(column, row)] = app::kMortar;
            }
}

/// A mean over 2 n + 1 pixels along rows, then along columns, three times: nearly a bell.
void blur(std::vector<double>& values, double sigma)
{
    const int n =
        static_cast<int>(std::lround(0.5 * (std::sqrt(4.0 * sigma * sigma + 1.0) - 1.0)));
    for (int round = 0; n > 0 && round < 6; ++round) {
        const std::vector<double> before = values;
        for (int row = 0; row < kRows; ++row)
            for (int column = 0; column < kColumns; ++column) {
                double sum = 0.0;
                for (int k = -n; k <= n; ++k) {
                    const int x = std::clamp(column + (round % 2 == 0 ? k : 0), 0,
                                             kColumns - 1),
                              y = std::clamp(row + (round % 2 == 0 ? 0 : k), 0, kRows - 1);
                    sum += before[static_cast<std::size_t>(y * kColumns + x)];
                }
                values[static_cast<std::size_t>(row * kColumns + column)] = sum / (2 * n + 1);
            }
    }
}

struct Normal {
    std::mt19937 random{7};
    double operator()() // the sum of twelve uniform numbers
    {
        double sum = -6.0;
        for (int i = 0; i < 12; ++i) sum += static_cast<double>(random()) / 4294967296.0;
        return sum;
    }
};

} // namespace

app::Labels rubble_truth()
{
    app::Labels truth{
        kColumns, kRows, 0, std::vector<int>(std::size_t{kColumns} * kRows, app::kMortar), {}};
    for (const dem::DrawnUnit& unit : rubble_units()) {
        for (int row = 0; row < kRows; ++row)
            for (int column = 0; column < kColumns; ++column)
                if (dem::is_inside(unit.outline,
                                   {(column + 0.5) / kColumns, 1.0 - (row + 0.5) / kRows}))
                    truth.label[truth.pixel(column, row)] = truth.stones;
        ++truth.stones;
    }
    truth.is_opening.assign(static_cast<std::size_t>(truth.stones), 0);
    for (int i = 0; i < kHalfMortar; ++i) erode(truth);
    return truth;
}

app::Picture photograph_of(const app::Labels& truth, const Look& look)
{
    Normal normal;
    std::vector<double> brighter;
    for (int s = 0; s < truth.stones; ++s) brighter.push_back(look.spread * normal());
    app::Picture picture{kColumns, kRows,
                         std::vector<std::uint8_t>(4 * truth.label.size(), 255)};
    for (std::size_t channel = 0; channel < 3; ++channel) {
        std::vector<double> values;
        for (const int l : truth.label)
            values.push_back(l == app::kMortar ? look.mortar[channel]
                                               : look.stones[l % 4][channel] + brighter[l]);
        blur(values, look.blur);
        for (std::size_t p = 0; p < values.size(); ++p) {
            const double right = static_cast<double>(p % kColumns) / kColumns;
            const double value =
                values[p] * (look.dark + (1.0 - look.dark) * right) + look.noise * normal();
            picture.rgba[4 * p + channel] =
                static_cast<std::uint8_t>(std::clamp(value, 0.0, 255.0));
        }
    }
    return picture;
}

std::string jpeg_of(const app::Picture& picture, int quality)
{
    tjhandle writer = tjInitCompress();
    unsigned char* bytes = nullptr;
    unsigned long size = 0;
    tjCompress2(writer, picture.rgba.data(), picture.columns, 0, picture.rows, TJPF_RGBA,
                &bytes, &size, TJSAMP_420, quality, 0);
    const std::string file(reinterpret_cast<const char*>(bytes), size);
    tjFree(bytes);
    tjDestroy(writer);
    return file;
}

} // namespace scenes

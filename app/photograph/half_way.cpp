#include "app/photograph/divided_stones.hpp"

#include <opencv2/imgproc.hpp>

#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace app {
namespace {

/// The mean colour of each label within a mask; nothing where it has too few pixels.
std::vector<cv::Vec4f> mean_colours(const cv::Mat& lab, const Stones& stones,
                                    const cv::Mat& within)
{
    constexpr float kLeastPixels = 10.0F;
    std::vector<cv::Vec4f> sum(static_cast<std::size_t>(stones.count) + 1);
    for (int r = 0; r < lab.rows; ++r)
        for (int c = 0; c < lab.cols; ++c) {
            if (within.at<uchar>(r, c) == 0) continue;
            const cv::Vec3f& colour = lab.at<cv::Vec3f>(r, c);
            sum[stones.label.at<int>(r, c)] += cv::Vec4f(colour[0], colour[1], colour[2], 1.0F);
        }
    for (cv::Vec4f& s : sum) s = s[3] < kLeastPixels ? cv::Vec4f() : s * (1.0F / s[3]);
    return sum;
}

/// The colours of a picture between those of mortar and stones.
struct Contrast {
    const cv::Mat& lab;
    cv::Mat ground;                ///< colour of mortar, in the light of each place
    std::vector<cv::Vec4f> stones; ///< colour of each; the fourth number is 0 where it has none

    [[nodiscard]] bool knows(int stone) const { return stones[stone][3] != 0.0F; }
    /// 0 as mortar, 1 as the stone.
    [[nodiscard]] float share(int row, int column, int stone) const
    {
        const cv::Vec4f& s = stones[stone];
        const cv::Vec3f base = ground.at<cv::Vec3f>(row, column),
                        full = cv::Vec3f(s[0], s[1], s[2]) - base;
        return (lab.at<cv::Vec3f>(row, column) - base).dot(full) /
               std::max(1.0F, full.dot(full));
    }
};

cv::Mat ball(int half)
{
    return cv::getStructuringElement(cv::MORPH_ELLIPSE, {2 * half - 1, 2 * half - 1});
}

cv::Mat eroded(const cv::Mat& mask, int pixels)
{
    cv::Mat less;
    cv::erode(mask, less, ball(pixels));
    return less;
}

/// The border that two stones share.
struct Common {
    double pixels = 0.0, stone = 0.0; ///< length, and sum of Contrast::share along it
};

std::map<std::pair<int, int>, Common> common_borders(const Contrast& contrast,
                                                     const cv::Mat& label)
{
    std::map<std::pair<int, int>, Common> all;
    const auto look = [&](int r, int c, int r2, int c2) {
        if (r2 >= label.rows || c2 >= label.cols) return;
        const int a = label.at<int>(r, c), b = label.at<int>(r2, c2);
        if (a == b || a == 0 || b == 0) return;
        Common& common = all[std::minmax(a, b)];
        common.pixels += 1.0;
        common.stone += std::min(contrast.share(r, c, a), contrast.share(r2, c2, b));
    };
    for (int r = 0; r < label.rows; ++r)
        for (int c = 0; c < label.cols; ++c) {
            look(r, c, r, c + 1);
            look(r, c, r + 1, c);
        }
    return all;
}

/// Two stones with a long border in common that is as bright as they are become one.
Stones joined(const Contrast& contrast, const Stones& stones)
{
    constexpr double kLong = 0.5;   // of the side of a square as large as the smaller stone
    constexpr double kStone = 0.75; // of the way from mortar to stone
    std::vector<double> area(static_cast<std::size_t>(stones.count) + 1);
    std::vector<int> name(area.size());
    std::iota(name.begin(), name.end(), 0);
    for (const int l : cv::Mat_<int>(stones.label)) area[l] += 1.0;
    const auto one = [&](int l) {
        while (name[l] != l) l = name[l];
        return l;
    };
    for (const auto& [pair, common] : common_borders(contrast, stones.label)) {
        const auto [a, b] = pair;
        if (common.pixels > kLong * std::sqrt(std::min(area[a], area[b])) &&
            common.stone > kStone * common.pixels)
            name[one(b)] = one(a);
    }
    Stones whole{stones.label.clone(), stones.count};
    for (int& l : cv::Mat_<int>(whole.label)) l = one(l);
    return whole;
}

} // namespace

double sharpness_of(const cv::Mat& lab, const Stones& stones)
{
    cv::Mat change, label, border;
    cv::morphologyEx(lab, change, cv::MORPH_GRADIENT, ball(2));
    cv::transform(change, change, cv::Mat(cv::Matx13f(1.0F, 1.0F, 1.0F)));
    stones.label.convertTo(label, CV_32F);
    cv::morphologyEx(label, border, cv::MORPH_GRADIENT, ball(2));
    const cv::Mat at = border > 0.0;
    return cv::mean(change, at)[0] / std::max(1e-6, cv::mean(change, ~at)[0]);
}

Stones at_half_way(const cv::Mat& lab, const Stones& stones)
{
    constexpr int kReach = 4; // [pixels] that a border moves at most
    Stones large{{}, stones.count};
    cv::resize(stones.label, large.label, lab.size(), 0, 0, cv::INTER_NEAREST);
    const cv::Mat mask = large.label != 0, inner = eroded(mask, kReach);
    cv::Mat reach;
    cv::dilate(mask, reach, ball(kReach + 1));
    const Contrast contrast{lab, surface_of(lab, eroded(~mask, kReach)),
                            mean_colours(lab, large, inner)};
    Stones moved = grown(large, reach);
    for (int r = 0; r < lab.rows; ++r)
        for (int c = 0; c < lab.cols; ++c) {
            int& label = moved.label.at<int>(r, c);
            if (label == 0 || inner.at<uchar>(r, c) != 0) continue;
            const bool is_stone = contrast.knows(label) ? contrast.share(r, c, label) > 0.5F
                                                        : large.label.at<int>(r, c) != 0;
            if (!is_stone) label = 0;
        }
    return clean(joined(contrast, moved));
}

} // namespace app

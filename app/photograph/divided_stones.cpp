#include "app/photograph/divided_stones.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cstddef>

namespace app {
namespace {

constexpr float kLeastHalf = 2.5F; // half the width of a stone [pixels]

cv::Mat ellipse(int width)
{
    return cv::getStructuringElement(cv::MORPH_ELLIPSE, {width, width});
}

/// A map of half widths, flooded from its highest place down. Two basins stay two where they
/// meet at a neck.
struct Basins {
    static constexpr float kNeck = 0.65F; ///< of the half width of the smaller stone
    const cv::Mat& half;                  ///< CV_32F; 0 outside of stones
    std::vector<int> parent;              ///< -1: not yet flooded
    std::vector<int> peak;                ///< the highest pixel of a basin, at its root

    [[nodiscard]] float at(int p) const { return half.ptr<float>()[p]; }
    [[nodiscard]] float top(int root) const { return at(peak[root]); }
    int root(int p)
    {
        while (parent[p] != p) p = parent[p] = parent[parent[p]];
        return p;
    }
    void meet(int p, int q)
    {
        int high = root(p), low = root(q);
        if (high == low) return;
        if (top(high) < top(low)) std::swap(high, low);
        const bool neck = at(p) < kNeck * top(low) && top(low) > kLeastHalf;
        if (!neck) parent[low] = high;
    }
    /// The pixel goes to the highest basin beside it.
    void flood(int p, const std::vector<int>& beside)
    {
        int best = p;
        parent[p] = peak[p] = p;
        for (const int q : beside)
            if (best == p || top(root(q)) > top(best)) best = root(q);
        parent[p] = best;
        for (const int q : beside) meet(p, q);
    }
};

std::vector<int> beside(int p, const cv::Size& size)
{
    std::vector<int> all;
    const int c = p % size.width, r = p / size.width;
    if (c > 0) all.push_back(p - 1);
    if (c + 1 < size.width) all.push_back(p + 1);
    if (r > 0) all.push_back(p - size.width);
    if (r + 1 < size.height) all.push_back(p + size.width);
    return all;
}

/// Each basin has a label of its own.
Stones basins_of(const cv::Mat& half)
{
    const auto n = static_cast<int>(half.total());
    Basins basins{half, std::vector<int>(half.total(), -1), std::vector<int>(half.total())};
    std::vector<int> order;
    for (int p = 0; p < n; ++p)
        if (basins.at(p) > 0.0F) order.push_back(p);
    std::ranges::stable_sort(order, std::ranges::greater(),
                             [&](int p) { return basins.at(p); });
    for (const int p : order) {
        std::vector<int> flooded = beside(p, half.size());
        std::erase_if(flooded, [&](int q) { return basins.parent[q] < 0; });
        basins.flood(p, flooded);
    }
    Stones stones{cv::Mat(half.size(), CV_32S, cv::Scalar(0)), 0};
    std::vector<int> number(half.total());
    for (const int p : order) {
        int& label = number[basins.root(p)];
        if (label == 0) label = ++stones.count;
        stones.label.ptr<int>()[p] = label;
    }
    return stones;
}

std::vector<cv::Rect> boxes_of(const Stones& stones)
{
    std::vector<cv::Rect> boxes(static_cast<std::size_t>(stones.count) + 1);
    for (int r = 0; r < stones.label.rows; ++r)
        for (int c = 0; c < stones.label.cols; ++c) {
            cv::Rect& box = boxes[stones.label.at<int>(r, c)];
            box = box.empty() ? cv::Rect(c, r, 1, 1) : box | cv::Rect(c, r, 1, 1);
        }
    return boxes;
}

using Outline = std::vector<cv::Point>;

/// The outline of the largest piece without its hairs; empty if it is narrow.
/// @param mask of one stone, within its box
Outline largest_outline(const cv::Mat& mask, cv::Point corner)
{
    constexpr int kFrame = 2, kHair = 5; // [pixels]
    cv::Mat framed, half;
    cv::copyMakeBorder(mask, framed, kFrame, kFrame, kFrame, kFrame, cv::BORDER_CONSTANT, 0);
    cv::distanceTransform(framed, half, cv::DIST_L2, 5);
    double most = 0.0;
    cv::minMaxLoc(half, nullptr, &most);
    if (most < kLeastHalf) return {};
    cv::morphologyEx(framed, framed, cv::MORPH_OPEN, ellipse(kHair));
    std::vector<Outline> outlines;
    cv::findContours(framed, outlines, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE,
                     corner - cv::Point(kFrame, kFrame));
    const auto largest = std::ranges::max_element(
        outlines, {}, [](const Outline& o) { return cv::contourArea(o); });
    return largest == outlines.end() ? Outline() : *largest;
}

/// Holes with fewer pixels are filled.
void fill_holes(cv::Mat& mask, double pixels)
{
    cv::Mat label, facts, centres;
    cv::connectedComponentsWithStats(~mask, label, facts, centres, 4);
    for (int r = 0; r < mask.rows; ++r)
        for (int c = 0; c < mask.cols; ++c)
            if (facts.at<int>(label.at<int>(r, c), cv::CC_STAT_AREA) < pixels)
                mask.at<uchar>(r, c) = 255;
}

} // namespace

Stones clean(const Stones& stones)
{
    constexpr double kDirt = 0.02; // of the mean area
    const std::vector<cv::Rect> boxes = boxes_of(stones);
    std::vector<Outline> outlines;
    double sum = 0.0;
    for (int l = 1; l <= stones.count; ++l) {
        if (boxes[l].empty()) continue;
        outlines.push_back(largest_outline(stones.label(boxes[l]) == l, boxes[l].tl()));
        if (outlines.back().empty())
            outlines.pop_back();
        else
            sum += cv::contourArea(outlines.back());
    }
    const double least = kDirt * sum / std::max(1.0, static_cast<double>(outlines.size()));
    Stones cleaned{cv::Mat(stones.label.size(), CV_32S, cv::Scalar(0)), 0};
    for (const Outline& outline : outlines)
        if (cv::contourArea(outline) >= least)
            cv::drawContours(cleaned.label, std::vector<Outline>{outline}, 0,
                             cv::Scalar(++cleaned.count), cv::FILLED);
    return cleaned;
}

Stones grown(const Stones& stones, const cv::Mat& within)
{
    cv::Mat distance, nearest;
    cv::distanceTransform(stones.label == 0, distance, nearest, cv::DIST_L2, 5,
                          cv::DIST_LABEL_PIXEL);
    const auto n = static_cast<int>(stones.label.total());
    const int* const label = stones.label.ptr<int>();
    const int* const at = nearest.ptr<int>();
    std::vector<int> of(stones.label.total() + 1);
    for (int p = 0; p < n; ++p)
        if (label[p] != 0) of[at[p]] = label[p];
    Stones result{cv::Mat(stones.label.size(), CV_32S, cv::Scalar(0)), stones.count};
    for (int p = 0; p < n; ++p)
        if (within.ptr<uchar>()[p] != 0) result.label.ptr<int>()[p] = of[at[p]];
    return result;
}

Stones divided(const Stoneness& map)
{
    constexpr double kCore = 0.3;   // of the map: surely stone
    constexpr double kValley = 0.5; // of the map: a line of mortar is deeper
    constexpr int kLines = 100; // as wide as such a line may be, side by side in the picture
    const int width = std::max(7, std::max(map.rows, map.cols) / kLines) | 1;
    const cv::Mat bounded = cv::min(map, 1.0);
    cv::Mat valley, half;
    cv::morphologyEx(bounded, valley, cv::MORPH_BLACKHAT, ellipse(width));
    cv::Mat core = (bounded > kCore) & (valley < kValley);
    fill_holes(core, 4.0 * width * width);
    cv::distanceTransform(core, half, cv::DIST_L2, 5);
    const Stones stones = clean(basins_of(half));
    return stones.count == 0 ? stones : clean(grown(stones, map > 0.0));
}

Shape shape_of(const Stones& stones, const Stoneness& map)
{
    std::vector<Outline> points(static_cast<std::size_t>(stones.count) + 1);
    std::vector<double> area(points.size());
    for (int r = 0; r < stones.label.rows; ++r)
        for (int c = 0; c < stones.label.cols; ++c) {
            const int l = stones.label.at<int>(r, c);
            if (l == 0) continue;
            points[l].emplace_back(c, r);
            area[l] += map.at<float>(r, c) > 0.0F ? 1.0 : 0.0;
        }
    double hulls = 0.0, areas = 0.0, most = 0.0;
    for (int l = 1; l <= stones.count; ++l) {
        if (points[l].empty()) continue; // none of its pixels is left
        Outline hull;
        cv::convexHull(points[l], hull);
        // through the centres of pixels: half a pixel more all around
        hulls += cv::contourArea(hull) + 0.5 * cv::arcLength(hull, true) + 1.0;
        areas += area[l];
        most = std::max(most, area[l]);
    }
    if (areas == 0.0) return {};
    return {areas / hulls, areas / static_cast<double>(stones.label.total()), most / areas};
}

} // namespace app

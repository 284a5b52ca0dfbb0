#include "app/photograph/mortar_maps.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace app {
namespace {

using Terms = cv::Matx<float, 1, 6>; // of a quadratic surface

/// Over a picture from -1 to 1.
Terms terms_at(const cv::Size& size, int column, int row)
{
    const float x = 2.0F * static_cast<float>(column) / static_cast<float>(size.width) - 1.0F,
                y = 2.0F * static_cast<float>(row) / static_cast<float>(size.height) - 1.0F;
    return {1.0F, x, y, x * x, x * y, y * y};
}

/// Divides values into two classes (Otsu 1979, IEEE Trans. SMC 9, 62-66).
double otsu(const cv::Mat& values)
{
    double low = 0.0, high = 0.0;
    cv::minMaxLoc(values, &low, &high);
    if (!(high > low)) return low;
    const double scale = 255.0 / (high - low);
    cv::Mat bytes;
    values.convertTo(bytes, CV_8U, scale, -scale * low);
    return low +
           cv::threshold(bytes, bytes, 0, 255, cv::THRESH_BINARY | cv::THRESH_OTSU) / scale;
}

cv::Mat brightness(const cv::Mat& lab)
{
    cv::Mat l;
    cv::extractChannel(lab, l, 0);
    return l;
}

/// Squared length of the difference of colours.
cv::Mat squared(const cv::Mat& difference)
{
    cv::Mat sum;
    cv::transform(difference.mul(difference), sum, cv::Mat(cv::Matx13f(1.0F, 1.0F, 1.0F)));
    return sum;
}

/// Standard deviation of noise (Immerkaer 1996, Computer Vision and Image Understanding 64,
/// 300-302).
double noise_of(const cv::Mat& bgr)
{
    const cv::Matx33f kernel(1, -2, 1, -2, 4, -2, 1, -2, 1);
    cv::Mat grey, edges;
    cv::cvtColor(bgr, grey, cv::COLOR_BGR2GRAY);
    cv::filter2D(grey, edges, CV_32F, kernel);
    return std::sqrt(0.5 * CV_PI) / 6.0 * cv::mean(cv::abs(edges))[0];
}

} // namespace

cv::Mat quiet_colours(const cv::Mat& bgr)
{
    constexpr double kNoisy = 6.0; // of 255
    const double noise = noise_of(bgr);
    cv::Mat median, smooth, lab;
    cv::medianBlur(bgr, median, noise > kNoisy ? 5 : 3);
    cv::bilateralFilter(median, smooth, 7, 10.0 + 2.0 * noise, 3.0);
    smooth.convertTo(smooth, CV_32F, 1.0 / 255.0);
    cv::cvtColor(smooth, lab, cv::COLOR_BGR2Lab);
    return lab;
}

cv::Mat surface_of(const cv::Mat& values, const cv::Mat& mask)
{
    constexpr int kStep = 4; // pixels from one that counts to the next
    const int channels = values.channels(), pixels = static_cast<int>(values.total());
    cv::Mat all(pixels, Terms::cols, CV_32F), rows, right, solved;
    const cv::Mat flat = values.reshape(1, pixels);
    for (int r = 0, p = 0; r < values.rows; ++r)
        for (int c = 0; c < values.cols; ++c, ++p) {
            all.at<Terms>(p) = terms_at(values.size(), c, r);
            if (r % kStep != 0 || c % kStep != 0 || mask.at<uchar>(r, c) == 0) continue;
            rows.push_back(all.row(p));
            right.push_back(flat.row(p));
        }
    if (rows.rows < 10 * Terms::cols || !cv::solve(rows, right, solved, cv::DECOMP_SVD))
        solved = cv::Mat::zeros(Terms::cols, channels, CV_32F);
    return cv::Mat(all * solved).reshape(channels, values.rows);
}

Stoneness by_threshold(const cv::Mat& lab, bool local)
{
    constexpr int kRounds = 5;
    constexpr double kAround = 0.15; // of the smaller side
    constexpr double kLeast = 2.0;   // half the difference of brightness, of 100
    const cv::Mat l = brightness(lab);
    cv::Mat guess = l, map;
    if (local) {
        cv::Mat around;
        cv::GaussianBlur(l, around, {}, kAround * std::min(l.rows, l.cols));
        guess = l - around;
    }
    cv::Mat upper = guess > otsu(guess);
    for (int round = 0; round < kRounds; ++round) {
        const cv::Mat high = surface_of(l, upper), low = surface_of(l, ~upper);
        map = (l - 0.5 * (high + low)) / cv::max(0.5 * (high - low), kLeast);
        upper = map > 0.0;
    }
    return map;
}

std::vector<Stoneness> by_clusters(const cv::Mat& lab, int clusters)
{
    constexpr int kTries = 4;
    cv::Mat flat = lab.clone(), small, which, centres;
    const cv::Mat light = surface_of(brightness(lab), cv::Mat(lab.size(), CV_8U, 255));
    const cv::Mat level = brightness(lab) - light;
    cv::insertChannel(level, flat, 0);
    cv::resize(flat, small, {}, 0.25, 0.25, cv::INTER_NEAREST);
    cv::theRNG().state = 1; // the same clusters in every run
    cv::kmeans(small.reshape(1, static_cast<int>(small.total())), clusters, which,
               {cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 40, 0.2}, kTries,
               cv::KMEANS_PP_CENTERS, centres);
    std::vector<cv::Mat> distance(static_cast<std::size_t>(clusters));
    for (int k = 0; k < clusters; ++k)
        cv::sqrt(squared(flat - cv::Scalar(cv::Vec3f(centres.ptr<float>(k)))), distance[k]);
    std::vector<Stoneness> maps;
    for (int mortar = 0; mortar < clusters; ++mortar) {
        cv::Mat nearest(lab.size(), CV_32F, cv::Scalar(1e9));
        for (int k = 0; k < clusters; ++k)
            if (k != mortar) nearest = cv::min(nearest, distance[k]);
        maps.emplace_back((distance[mortar] - nearest) / (distance[mortar] + nearest + 1e-3));
    }
    return maps;
}

Stoneness by_lines(const cv::Mat& lab, bool dark)
{
    constexpr int kLines = 50; // as wide as a joint may be, side by side in the picture
    const int width = std::max(5, std::max(lab.rows, lab.cols) / kLines) | 1;
    cv::Mat l, lines;
    cv::GaussianBlur(brightness(lab), l, {}, 1.0);
    cv::morphologyEx(l, lines, dark ? cv::MORPH_BLACKHAT : cv::MORPH_TOPHAT,
                     cv::getStructuringElement(cv::MORPH_ELLIPSE, {width, width}));
    return 1.0 - lines / std::max(1.0, otsu(lines));
}

Stoneness by_mortar(const cv::Mat& lab, const Stoneness& first)
{
    constexpr int kRounds = 4;
    Stoneness map = first;
    for (int round = 0; round < kRounds; ++round) {
        cv::Mat away; // its logarithm has two hills, however much stones differ
        cv::log(squared(lab - surface_of(lab, map < 0.0)) + 1.0, away);
        map = away / std::max(1.0, otsu(away)) - 1.0;
    }
    return map;
}

} // namespace app

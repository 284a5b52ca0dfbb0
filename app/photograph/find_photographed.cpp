#include "app/photograph/divided_stones.hpp"
#include "app/photograph/photograph.hpp"
#include "app/text/number_text.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace app {
namespace {

constexpr int kTrialSide = 700; // [pixels]: methods are tried on a smaller picture

/// One guess at the stones.
struct Trial {
    StoneMethod method = StoneMethod::best;
    Stones stones;
    double score = 0.0;
};

double score_of(const Shape& shape)
{
    constexpr double kLargest = 0.35; // mortar that was taken for stone is one large piece
    constexpr int kCompact = 6;       // counts more than how much is covered
    return shape.largest > kLargest ? 0.0 : std::pow(shape.solidity, kCompact) * shape.cover;
}

/// The best of all guesses.
struct Trials {
    Trial best;

    void add(StoneMethod method, const Stoneness& map)
    {
        constexpr double kLeast = 0.1, kMost = 0.99; // of the picture can be stone
        const double share =
            static_cast<double>(cv::countNonZero(map > 0.0)) / static_cast<double>(map.total());
        if (share < kLeast || share > kMost) return;
        const Stones stones = divided(map);
        const double score = score_of(shape_of(stones, map));
        if (score > best.score) best = {method, stones, score};
    }

    /// As it is, and with the mortar by its colour.
    void add_both(StoneMethod method, const cv::Mat& lab, const Stoneness& map)
    {
        add(method, map);
        add(method, by_mortar(lab, map));
    }
};

Trial best_trial(const cv::Mat& lab, StoneMethod method)
{
    const auto wanted = [&](StoneMethod m) {
        return method == m || method == StoneMethod::best;
    };
    Trials trials;
    if (wanted(StoneMethod::threshold))
        for (const bool local : {false, true}) {
            const Stoneness map = by_threshold(lab, local);
            trials.add_both(StoneMethod::threshold, lab, map);
            trials.add_both(StoneMethod::threshold, lab, -map);
        }
    if (wanted(StoneMethod::kmeans))
        for (const int clusters : {3, 5})
            for (const Stoneness& map : by_clusters(lab, clusters))
                trials.add_both(StoneMethod::kmeans, lab, map);
    if (wanted(StoneMethod::watershed))
        for (const bool dark : {true, false})
            trials.add(StoneMethod::watershed, by_lines(lab, dark));
    return trials.best;
}

cv::Mat at_most(const cv::Mat& image, int longest)
{
    const double scale = static_cast<double>(longest) / std::max(image.rows, image.cols);
    cv::Mat small = image;
    if (scale < 1.0) cv::resize(image, small, {}, scale, scale, cv::INTER_AREA);
    return small;
}

/// Mortar of a pixel or two is lost with the noise: small photographs are made larger.
cv::Mat at_usual_size(const cv::Mat& image)
{
    constexpr double kMost = 3.0; // times
    const double scale = static_cast<double>(kTrialSide) / std::max(image.rows, image.cols);
    cv::Mat large = at_most(image, kLongestSide);
    if (scale > 1.0)
        cv::resize(image, large, {}, std::min(scale, kMost), std::min(scale, kMost),
                   cv::INTER_CUBIC);
    return large;
}

/// Pixels near the colour of openings, but for single ones.
cv::Mat openings_of(const cv::Mat& bgr)
{
    constexpr int kNear = 80; // of 255, for each colour
    const cv::Scalar colour(kOpeningColour & 255, kOpeningColour >> 8 & 255,
                            kOpeningColour >> 16);
    cv::Mat mask;
    cv::inRange(bgr, colour - cv::Scalar::all(kNear), colour + cv::Scalar::all(kNear), mask);
    cv::morphologyEx(mask, mask, cv::MORPH_OPEN, cv::Mat::ones(5, 5, CV_8U));
    return mask;
}

/// @throws ConfigError
void check_wall(const DrawingFrame& frame, const Stones& stones, const Shape& shape,
                double sharpness)
{
    constexpr int kFewest = 4;
    constexpr double kSolidity = 0.87; // of walls 0.92 and more, of grass and people 0.86
    constexpr double kCover = 0.3;     // as of a painted picture
    constexpr double kSharp = 1.5;     // of walls 2 and more
    if (stones.count >= kFewest && shape.solidity >= kSolidity && shape.cover >= kCover &&
        sharpness >= kSharp)
        return;
    refuse(
        frame, 0,
        "shows no stones that differ from their mortar (the best guess: " +
            counted(static_cast<std::size_t>(stones.count), "piece", "pieces") + ", " +
            fixed(shape.solidity, 2) + " as compact as their hulls, " +
            fixed(100.0 * shape.cover, 0) + " % of the picture, borders " +
            fixed(sharpness, 1) +
            " times as sharp as the rest); cut it to the wall and take it in even light, or "
            "write "
            "--method threshold, kmeans or watershed to have a guess and correct it by hand");
}

Picture as_picture(const cv::Mat& bgr)
{
    Picture picture{bgr.cols, bgr.rows, std::vector<std::uint8_t>(4 * bgr.total())};
    cv::Mat rgba(bgr.size(), CV_8UC4, picture.rgba.data());
    cv::cvtColor(bgr, rgba, cv::COLOR_BGR2RGBA);
    return picture;
}

/// Connected pieces of stones and openings. The colour of openings runs over a few pixels,
/// which become mortar.
Labels as_labels(const Stones& stones, const cv::Mat& openings)
{
    constexpr int kRuns = 7, kLeastPixels = 16;
    constexpr int kOpening = -2; // stones have positive kinds
    cv::Mat around;
    cv::dilate(openings, around, cv::Mat::ones(kRuns, kRuns, CV_8U));
    Labels labels{stones.label.cols, stones.label.rows, 0, {}, {}};
    labels.label.assign(stones.label.total(), kMortar);
    std::vector<int> kind(labels.label.size(), kMortar);
    for (std::size_t p = 0; p < kind.size(); ++p) {
        const int stone = stones.label.ptr<int>()[p];
        if (openings.ptr<uchar>()[p] != 0)
            kind[p] = kOpening;
        else if (stone != 0 && around.ptr<uchar>()[p] == 0)
            kind[p] = stone;
    }
    std::vector<char> seen(kind.size());
    for (std::size_t first = 0; first < kind.size(); ++first) {
        if (seen[first] || kind[first] == kMortar) continue;
        const std::vector<std::size_t> piece = connected(labels, kind, first, seen);
        if (piece.size() < kLeastPixels) continue;
        for (const std::size_t p : piece) labels.label[p] = labels.stones;
        labels.is_opening.push_back(kind[first] == kOpening ? 1 : 0);
        ++labels.stones;
    }
    return labels;
}

} // namespace

FoundStones find_photographed(const DrawingFrame& frame, const Picture& picture,
                              StoneMethod method)
{
    cv::Mat bgr;
    cv::cvtColor(cv::Mat(picture.rows, picture.columns, CV_8UC4,
                         const_cast<std::uint8_t*>(picture.rgba.data())),
                 bgr, cv::COLOR_RGBA2BGR);
    bgr = at_usual_size(bgr);
    FoundStones found;
    found.photograph = as_picture(bgr);
    const cv::Mat openings = openings_of(bgr);
    Trial trial;
    cv::Scalar mortar = cv::mean(bgr, ~openings); // until it is known
    for (int round = 0; round < (cv::countNonZero(openings) > 0 ? 2 : 1); ++round) {
        bgr.setTo(mortar, openings);
        const cv::Mat small = at_most(bgr, kTrialSide);
        trial = best_trial(quiet_colours(small), method);
        if (trial.stones.count > 0) mortar = cv::mean(small, trial.stones.label == 0);
    }
    if (trial.stones.count == 0) check_wall(frame, {}, {}, 0.0);
    const cv::Mat lab = quiet_colours(bgr);
    const Stones stones = at_half_way(lab, trial.stones);
    const Shape shape = shape_of(stones, cv::Mat::ones(bgr.size(), CV_32F));
    if (method == StoneMethod::best)
        check_wall(frame, stones, shape, sharpness_of(lab, stones));
    found.method = trial.method;
    found.solidity = shape.solidity;
    found.labels = as_labels(stones, openings);
    return found;
}

} // namespace app

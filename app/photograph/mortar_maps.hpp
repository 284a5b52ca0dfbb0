#pragma once
/// How sure each pixel of a photograph is stone, by several methods.

#include <opencv2/core.hpp>

#include <vector>

namespace app {

/// CV_32F: 1 as a stone is, 0 halfway between stone and mortar, negative in the mortar.
using Stoneness = cv::Mat;

/// Colours without noise, which differ by what an eye sees (CIE L*a*b*, CV_32FC3).
[[nodiscard]] cv::Mat quiet_colours(const cv::Mat& bgr);

/// The quadratic surface through the values of the pixels of a mask, one for each channel: one
/// colour in the light of each place.
[[nodiscard]] cv::Mat surface_of(const cv::Mat& values, const cv::Mat& mask);

/// Stones are brighter than the mortar of their place; the negative map has darker ones.
/// @param local the first guess compares with the surroundings, not with the whole picture
[[nodiscard]] Stoneness by_threshold(const cv::Mat& lab, bool local);

/// Colours in clusters: a map for each cluster that could be the mortar.
[[nodiscard]] std::vector<Stoneness> by_clusters(const cv::Mat& lab, int clusters);

/// Joints are thin lines, darker than both sides or brighter.
[[nodiscard]] Stoneness by_lines(const cv::Mat& lab, bool dark);

/// Mortar has the colour of the mortar of the first map, in the light of its place.
[[nodiscard]] Stoneness by_mortar(const cv::Mat& lab, const Stoneness& first);

} // namespace app

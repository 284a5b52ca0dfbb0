#pragma once
/// The head of the file of a study.

#include "app/sampling/sample_plan.hpp"
#include "app/store/store_head.hpp"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace app {

struct GeometryInput;
struct Sampling;
struct Study;

/// How many times slower an audit pushes. The error of a wall is about 4/3 of the difference
/// where it falls with the speed.
constexpr std::uint32_t kAuditSlower = 4; // choice

/// Walls per stress level: 1 where nothing is random.
[[nodiscard]] std::uint32_t samples_of(const GeometryInput& geometry, const Sampling& sampling);

/// Sizes through which the design has grown: those in the file, if there is one, and the
/// study's.
/// @throws StoreError
[[nodiscard]] std::vector<std::uint32_t> design_sizes(const GeometryInput& geometry,
                                                      const Sampling& sampling,
                                                      const std::filesystem::path& file);

/// @throws ConfigError for a file that is there and no HDF5 file
void check_is_study(const std::filesystem::path& file);

/// Sentence about walls that another revision of the solver pushed; empty where it was this
/// one.
[[nodiscard]] std::string other_revision_text(const StoreHead& head);

[[nodiscard]] StoreHead head_of(const Study& study, const dem::Layout& layout,
                                const SamplePlan& plan, std::vector<std::uint32_t> sizes);

} // namespace app

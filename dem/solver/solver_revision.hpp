#pragma once

namespace dem {

/// Revision of what walls answer. It goes up by one with every change after which the same wall
/// of the same study has another curve, other facts or other random inputs: a law, a default,
/// the mesh, the order of a sum, a draw. Changes of how curves are read do not count. Each step
/// is a row of *Changes that move results* in CHANGELOG.md.
///   1  version 0.1.0 (commit 5349d36)
///   2  version 0.2.0; nobody had the states between
constexpr int kSolverRevision = 11;

} // namespace dem

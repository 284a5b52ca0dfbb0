#include "app/verbs.hpp"
#include "app/wall_verbs.hpp"

#include <array>

namespace app {
namespace {

constexpr std::array kVerbs = {kPushVerb, kSceneVerb, kNewVerb, kHelpVerb, kVersionVerb};

} // namespace

std::span<const Verb> verbs() { return kVerbs; }

} // namespace app

#include "app/report/film_shelf.hpp"

#include "app/report/report_choice.hpp"

#include <iterator>

namespace app {

void FilmShelf::put(WallKey key, dem::FailureMode mode, std::span<const dem::Snapshot> frames)
{
    Samples& samples = films_[{key.level, mode}];
    const std::size_t most = walls_in_page(frames.front().blocks.size());
    if (samples.size() >= most && key.sample > samples.rbegin()->first) return;
    samples[key.sample] = film_of(frames);
    if (samples.size() > most) samples.erase(std::prev(samples.end()));
}

const Film* FilmShelf::find(WallKey key) const
{
    using enum dem::FailureMode;
    for (const dem::FailureMode mode : {rocking, sliding, mixed}) {
        const auto group = films_.find({key.level, mode});
        if (group == films_.end()) continue;
        const auto film = group->second.find(key.sample);
        if (film != group->second.end()) return &film->second;
    }
    return nullptr;
}

} // namespace app

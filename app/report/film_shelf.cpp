#include "app/report/film_shelf.hpp"

#include "app/report/report_choice.hpp"

#include <iterator>

namespace app {

void FilmShelf::put(WallKey key, bool rocking, std::span<const dem::Snapshot> frames)
{
    films_[{key.level, !rocking}].erase(key.sample);
    Samples& samples = films_[{key.level, rocking}];
    const std::size_t most = walls_in_page(frames.front().blocks.size());
    const bool full = samples.size() >= most && !samples.contains(key.sample);
    if (full && key.sample > samples.rbegin()->first) return;
    if (full) samples.erase(std::prev(samples.end()));
    samples[key.sample] = film_of(frames);
}

const Film* FilmShelf::find(WallKey key) const
{
    for (const bool rocking : {false, true}) {
        const auto group = films_.find({key.level, rocking});
        if (group == films_.end()) continue;
        const auto film = group->second.find(key.sample);
        if (film != group->second.end()) return &film->second;
    }
    return nullptr;
}

std::size_t FilmShelf::size() const
{
    std::size_t n = 0;
    for (const auto& [group, samples] : films_) n += samples.size();
    return n;
}

} // namespace app

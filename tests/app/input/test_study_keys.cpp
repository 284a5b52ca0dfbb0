#include "app/input/keys/study_keys.hpp"

#include "app/input/keys/key_values.hpp"
#include "app/input/study/units.hpp"
#include "app/study_texts.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <vector>

using app::Key;
using app::study_keys;

namespace {

/// A value that the field can hold and does not have.
std::vector<double> other_value(const Key& key, const app::Study& study)
{
    const std::vector<double> now = key.field.get(study);
    if (now.empty()) return {1.0};
    for (const app::Named& name : key.names) {
        if (name.value != now.front()) return {name.value};
    }
    return {now.front() + 1.0};
}

} // namespace

TEST_CASE("study keys: names differ, and the keys of a section stand together",
          "[app][study_keys]")
{
    std::set<std::string_view> names, sections;
    std::string_view section;
    for (const Key& key : study_keys()) {
        INFO(key.name);
        CHECK(names.insert(key.name).second);
        if (app::section_of(key.name) != section) {
            section = app::section_of(key.name);
            CHECK(sections.insert(section).second);
        }
    }
}

TEST_CASE("study keys: a text whose default is none takes \"none\"", "[app][study_keys]")
{
    int many = 0;
    for (const Key& key : study_keys()) {
        if (key.kind != app::Kind::text || key.derived.rule != "none") continue;
        INFO(key.name);
        ++many;
        app::Study study;
        key.field.set(study, app::parse_value(key, "none"));
        CHECK(key.field.get(study) == key.field.get(app::Study()));
        CHECK(app::parse_value(key, "nones").size() == 5);
    }
    CHECK(many >= 6);
}

TEST_CASE("study keys: each key has its own place in the study", "[app][study_keys]")
{
    const app::Study initial;
    for (const Key& changed : study_keys()) {
        app::Study study;
        changed.field.set(study, other_value(changed, initial));
        for (const Key& key : study_keys()) {
            INFO(changed.name << " seen by " << key.name);
            const bool moved = key.field.get(study) != key.field.get(initial);
            CHECK(moved == (key.name == changed.name));
        }
    }
}

TEST_CASE("study keys: examples and defaults are values of their keys", "[app][study_keys]")
{
    for (const Key& key : study_keys()) {
        INFO(key.name);
        CHECK_FALSE(key.meaning.empty());
        if (!key.example.empty()) {
            CHECK_NOTHROW(app::parse_value(key, key.example));
            CHECK(key.derived.rule.empty());
        } else if (key.derived.rule.empty()) {
            const app::Study initial;
            CHECK(app::parse_value(key, app::value_text(key, initial)) ==
                  key.field.get(initial));
        }
    }
}

TEST_CASE("study keys: a named value is read and written by its name, one of two by the first",
          "[app][study_keys]")
{
    for (const Key& key : study_keys()) {
        for (const app::Named& name : key.names) {
            INFO(key.name << " = " << name.word);
            app::Study study;
            key.field.set(study, app::parse_value(key, name.word));
            CHECK(key.field.get(study).front() == name.value);
            const auto first = std::ranges::find(key.names, name.value, &app::Named::value);
            CHECK(app::value_text(key, study) == first->word);
        }
    }
}

TEST_CASE("study keys: words stand for the values that the solver reads", "[app][study_keys]")
{
    const app::Study study =
        study_texts::read_good({"solver.block_modes=rigid", "solver.beam_modes=all",
                                "wall.bond=stack", "wall.toe=free"});
    CHECK(study.discretisation.block_modes == 3);
    CHECK(study.discretisation.beam_modes == 0);
    CHECK(study.wall.bond_offset == 0.0);
    CHECK(study.wall.toe == dem::Toe::free);
    CHECK(study_texts::read_good({"wall.bond=running"}).wall.bond_offset == 0.5);
}

TEST_CASE("study keys: open ends of a range are refused, closed ends are not",
          "[app][study_keys]")
{
    const auto is_read = [](std::string_view name, std::string_view text) {
        for (const Key& key : study_keys()) {
            if (key.name != name) continue;
            try {
                (void)app::parse_value(key, text);
                return true;
            } catch (const app::BadValue&) {
                return false;
            }
        }
        FAIL("no such key");
        return false;
    };
    CHECK(is_read("joint.friction_angle", "0 deg"));
    CHECK(is_read("joint.friction_angle", "89.999 deg"));
    CHECK_FALSE(is_read("joint.friction_angle", "90 deg"));
    CHECK_FALSE(is_read("joint.friction_angle", "-1e-9 deg"));
    CHECK(is_read("wall.length", "1 mm"));
    CHECK(is_read("wall.length", "100 m"));
    CHECK_FALSE(is_read("wall.length", "100.1 m"));
    CHECK_FALSE(is_read("stone.young_modulus", "0 GPa"));
    CHECK_FALSE(is_read("load.vertical_stress", "0.5, -0.1 MPa"));
    CHECK(is_read("load.targets", "5, -5 mm"));
    CHECK(is_read("wall.bond", "0.25"));
    CHECK_FALSE(is_read("wall.bond", "1"));
}

#include "dem/block/model.hpp"
#include "dem/contact/contact_operator.hpp"
#include "dem/scene/drawn_layout.hpp"
#include "dem/scene/rubble.hpp"
#include "dem/solver/state/step_tables.hpp"
#include "scenes/paper_wall.hpp"
#include "tests/dem/random_lanes.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace {

using dem::ContactOperator;
using dem::multiply_add;
using random_lanes::numbers;
using random_lanes::same;

/// A block with ports on some of more contacts, in no order.
struct Block {
    int ports, modes, contacts;
    std::vector<int> contact;
    std::vector<double> area;
    std::vector<double> matrix; ///< modes x 2 ports
    ContactOperator own;
    Block(int n_ports, int n_modes, std::mt19937_64& random)
        : ports(n_ports), modes(n_modes), contacts(2 * n_ports + 1)
    {
        area = numbers<double>(contacts, random);
        matrix = numbers<double>(static_cast<std::size_t>(2) * ports * modes, random);
        for (int p = 0; p < ports; ++p)
            contact.push_back((7 + 2 * p) % contacts); // no contact twice
        own = dem::with_own_matrix({ports, modes, {}, matrix, {}});
    }
    [[nodiscard]] double at(int row, int mode) const { return matrix[mode * 2 * ports + row]; }
};

template <class Check> void for_all_sizes(Check check)
{
    std::mt19937_64 random(6);
    for (int ports = 1; ports <= 9; ++ports)
        for (int modes = 1; modes <= 25; ++modes) check(Block(ports, modes, random), random);
}

/// Random stones, as many as have matrices of more than a megabyte.
dem::Model stones()
{
    const scenes::Scene s = scenes::paper_wall(0.50);
    dem::DrawnWall drawn;
    for (dem::Outline& outline : dem::rubble({.length = 2.4, .height = 1.0}))
        drawn.units.push_back({std::move(outline)});
    dem::Loads loads = s.loads;
    loads.height = 1.0 + s.beam.height;
    return dem::discretise(dem::drawn_layout(drawn, s.beam.height), s.stone, s.beam, loads,
                           {s.joint, s.crack});
}

} // namespace

TEMPLATE_TEST_CASE("own matrix: gather is a plain double loop in four parts, bit for bit, in "
                   "every size",
                   "[dem][own_matrix]", double, dem::Pack)
{
    int wrong = 0;
    for_all_sizes([&](const Block& b, std::mt19937_64& random) {
        const auto stress = numbers<TestType>(2 * b.contacts, random);
        std::vector<TestType> modal(b.modes + 1, TestType(7.0)); // one more: not touched
        gather(b.own, b.contact.data(), b.area.data(), stress.data(), modal.data());
        wrong += dem::lane(modal.back(), 0) != 7.0;
        for (int i = 0; i < b.modes; ++i) {
            TestType part[4] = {TestType(0.0), TestType(0.0), TestType(0.0), TestType(0.0)};
            for (int row = 0; row < 2 * b.ports; ++row) {
                const int k = b.contact[row / 2];
                const TestType force = TestType(-b.area[k]) * stress[2 * k + row % 2];
                part[row % 4] = multiply_add(TestType(b.at(row, i)), force, part[row % 4]);
            }
            wrong += !same(modal[i], (part[0] + part[2]) + (part[1] + part[3]));
        }
    });
    CHECK(wrong == 0);
}

TEMPLATE_TEST_CASE("own matrix: scatter is a plain double loop, bit for bit, in every size",
                   "[dem][own_matrix]", double, dem::Pack)
{
    int wrong = 0;
    for_all_sizes([&](const Block& b, std::mt19937_64& random) {
        const auto velocity = numbers<TestType>(b.modes, random);
        auto expected = numbers<TestType>(2 * b.contacts, random);
        auto du = expected;
        scatter(b.own, b.contact.data(), velocity.data(), du.data());
        for (int row = 0; row < 2 * b.ports; ++row) {
            TestType sum(0.0);
            for (int i = 0; i < b.modes; ++i)
                sum = multiply_add(TestType(b.at(row, i)), velocity[i], sum);
            expected[2 * b.contact[row / 2] + row % 2] += sum;
        }
        for (std::size_t k = 0; k < du.size(); ++k) wrong += !same(du[k], expected[k]);
    });
    CHECK(wrong == 0);
}

TEST_CASE(
    "own matrix: many stones store theirs once, and the work of their contacts is the work "
    "of their modes",
    "[dem][own_matrix]")
{
    const dem::Model m = stones();
    const dem::StepTables t = dem::step_tables(m);
    std::size_t bytes = 0, twice = 0;
    std::mt19937_64 random(9);
    const auto stress = numbers<double>(2 * t.area.size(), random);
    const auto v = numbers<double>(m.n_modes, random);
    std::vector<double> du(stress.size(), 0.0), modal(m.n_modes);
    double on_modes = 0.0, on_contacts = 0.0, size = 0.0;
    for (const auto& b : t.blocks) {
        const ContactOperator& a = t.matrices[b.element];
        const int* contact = t.port_contact.data() + b.first_port;
        gather(a, contact, t.area.data(), stress.data(), modal.data());
        scatter(a, contact, v.data() + b.first_mode, du.data());
        for (int i = 0; i < b.modes; ++i) {
            on_modes += modal[i] * v[b.first_mode + i];
            size += std::abs(modal[i] * v[b.first_mode + i]);
        }
        bytes += bytes_of(a);
        twice += std::size_t{4} * sizeof(double) * a.ports * a.modes;
    }
    for (std::size_t row = 0; row < du.size(); ++row)
        on_contacts += t.area[row / 2] * stress[row] * du[row];
    CHECK(std::abs(on_modes + on_contacts) < 1e-13 * size); // the stresses resist
    CHECK(bytes < 0.6 * static_cast<double>(twice));
}

#include "dem/block/model.hpp"
#include "dem/contact/contact_operator.hpp"
#include "dem/solver/state/step_tables.hpp"
#include "scenes/paper_wall.hpp"
#include "tests/dem/random_lanes.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

namespace {

using dem::ContactOperator;
using dem::multiply_add;
using random_lanes::numbers;

constexpr int kMostPorts = 25, kMostModes = 45;

/// A block with ports on some of more contacts, in no order.
template <class Real> struct Block {
    ContactOperator matrix;
    std::vector<int> contact;
    std::vector<double> area; ///< not needed: to_modes has it
    int n_contacts;
    Block(int ports, int modes, std::mt19937_64& random) : n_contacts(ports + 3)
    {
        const auto size = static_cast<std::size_t>(2) * ports * modes;
        matrix = {
            ports, modes, numbers<double>(size, random), numbers<double>(size, random), {}};
        contact.resize(n_contacts);
        std::iota(contact.begin(), contact.end(), 0);
        for (int k = n_contacts - 1; k > 0; --k)
            std::swap(contact[k], contact[random() % (k + 1)]);
        contact.resize(ports);
    }
};

template <class Real> bool same(const std::vector<Real>& a, const std::vector<Real>& b)
{
    return std::ranges::equal(a, b, random_lanes::same<Real>);
}

/// Row by row of to_modes, each product added in the order of the ports.
template <class Real>
std::vector<Real> gathered(const Block<Real>& b, const std::vector<Real>& stress)
{
    const auto& a = b.matrix;
    std::vector<Real> modal(a.modes, Real(0.0));
    for (int i = 0; i < a.modes; ++i)
        for (int row = 0; row < 2 * a.ports; ++row)
            modal[i] = multiply_add(Real(a.to_modes[row * a.modes + i]),
                                    stress[2 * b.contact[row / 2] + row % 2], modal[i]);
    return modal;
}

/// Terms that scatter adds to du: each row is summed on its own, in the order of the modes.
template <class Real>
std::vector<Real> scattered(const Block<Real>& b, const std::vector<Real>& velocity,
                            std::vector<Real> du)
{
    const auto& a = b.matrix;
    for (int row = 0; row < 2 * a.ports; ++row) {
        Real sum(0.0);
        for (int i = 0; i < a.modes; ++i)
            sum = multiply_add(Real(a.to_contacts[i * 2 * a.ports + row]), velocity[i], sum);
        du[2 * b.contact[row / 2] + row % 2] += sum;
    }
    return du;
}

/// Calls check(block) for every size.
template <class Real, class Check> void for_all_sizes(Check check)
{
    std::mt19937_64 random(5);
    for (int ports = 1; ports <= kMostPorts; ++ports)
        for (int modes = 1; modes <= kMostModes; ++modes)
            check(Block<Real>(ports, modes, random), random);
}

/// (sigma, tau) or (normal, tangential) at every contact of a wall.
double work(const dem::StepTables& t, const std::vector<double>& stress,
            const std::vector<double>& du)
{
    double sum = 0.0;
    for (std::size_t row = 0; row < du.size(); ++row)
        sum += t.area[row / 2] * stress[row] * du[row];
    return sum;
}

} // namespace

TEMPLATE_TEST_CASE(
    "contact operator: gather is a plain double loop, bit for bit, in every size",
    "[dem][contact_operator]", double, dem::Pack)
{
    int wrong = 0;
    for_all_sizes<TestType>([&](const Block<TestType>& b, std::mt19937_64& random) {
        const auto stress = numbers<TestType>(2 * b.n_contacts, random);
        std::vector<TestType> modal(b.matrix.modes + 1, TestType(7.0)); // one more: not touched
        gather(b.matrix, b.contact.data(), b.area.data(), stress.data(), modal.data());
        wrong += dem::lane(modal.back(), 0) != 7.0;
        modal.pop_back();
        wrong += !same(modal, gathered(b, stress));
    });
    CHECK(wrong == 0);
}

TEMPLATE_TEST_CASE(
    "contact operator: scatter is a plain double loop, bit for bit, in every size",
    "[dem][contact_operator]", double, dem::Pack)
{
    int wrong = 0;
    for_all_sizes<TestType>([&](const Block<TestType>& b, std::mt19937_64& random) {
        const auto velocity = numbers<TestType>(b.matrix.modes, random);
        const auto before = numbers<TestType>(2 * b.n_contacts, random);
        auto du = before;
        scatter(b.matrix, b.contact.data(), velocity.data(), du.data());
        wrong += !same(du, scattered(b, velocity, before));
    });
    CHECK(wrong == 0);
}

TEST_CASE("contact operator: in a wall, what the stresses do on the modes is what they do on "
          "the contacts",
          "[dem][contact_operator]")
{
    scenes::Scene s = scenes::paper_wall(0.50);
    s.wall.base = GENERATE(dem::Base::fixed, dem::Base::joint);
    dem::Discretisation d;
    d.block_modes = GENERATE(3, 6, 12, 0);
    const dem::Model m = scenes::model_of(s, d);
    const dem::StepTables t = dem::step_tables(m);
    std::mt19937_64 random(9);
    const auto stress = numbers<double>(2 * t.area.size(), random);
    const auto v = numbers<double>(m.n_modes, random);
    std::vector<double> du(stress.size(), 0.0), modal(m.n_modes);
    double on_modes = 0.0, size = 0.0;
    for (const auto& b : t.blocks) {
        const int* contact = t.port_contact.data() + b.first_port;
        gather(t.matrices[b.element], contact, t.area.data(), stress.data(), modal.data());
        scatter(t.matrices[b.element], contact, v.data() + b.first_mode, du.data());
        for (int i = 0; i < b.modes; ++i) {
            on_modes += modal[i] * v[b.first_mode + i];
            size += std::abs(modal[i] * v[b.first_mode + i]);
        }
    }
    CHECK(std::abs(on_modes + work(t, stress, du)) < 1e-13 * size); // the stresses resist
}

TEST_CASE("contact operator: both of its halves hold the same numbers",
          "[dem][contact_operator]")
{
    const dem::Model m = scenes::model_of(scenes::paper_wall(0.50));
    const dem::StepTables t = dem::step_tables(m);
    int wrong = 0;
    for (const auto& b : t.blocks) {
        const ContactOperator& a = t.matrices[b.element];
        for (int row = 0; row < 2 * a.ports; ++row)
            for (int i = 0; i < a.modes; ++i) {
                const std::size_t in = row * a.modes + i, out = i * 2 * a.ports + row;
                const double area = t.area[t.port_contact[b.first_port + row / 2]];
                // Blocks of an element share its matrix; their areas differ in the last digit.
                wrong += std::abs(a.to_modes[in] + area * a.to_contacts[out]) >
                         1e-14 * std::abs(a.to_modes[in]);
            }
    }
    CHECK(wrong == 0);
}

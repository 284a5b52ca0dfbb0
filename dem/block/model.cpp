#include "dem/block/model.hpp"

#include "dem/block/contact_count.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace dem {

namespace {

FacePoints points_of(const Face& f, const Layout& layout, const Discretisation& d)
{
    return face_points(d.face_rule, static_cast<int>(contact_count(f, layout, d)),
                       d.zones_per_interval);
}

Motion motion_of(const Layout& layout, LoadPattern pattern, int block)
{
    const bool driven = block == layout.beam && pattern == LoadPattern::beam;
    return driven ? Motion::driven : layout.blocks[block].motion;
}

/// Everything that a block's element depends on, as numbers. Blocks with equal keys share one
/// element.
std::vector<double> key_of(const BlockSpec& s)
{
    const auto micron = [](double x) { return std::round(x * 1e6); };
    std::vector<double> key{micron(s.width), micron(s.height), static_cast<double>(s.motion),
                            s.material.young_modulus, s.material.poisson_ratio};
    for (const Point p : s.outline) key.insert(key.end(), {micron(p.x), micron(p.z)});
    for (const BlockEdge& e : s.edges)
        for (const double x :
             {micron(e.from.x), micron(e.from.z), micron(e.to.x), micron(e.to.z), e.kn, e.ks,
              static_cast<double>(e.points.position.size())})
            key.push_back(x);
    return key;
}

std::string name_of(int block) { return "block " + std::to_string(block + 1); }

/// @throws std::invalid_argument if its outline or its joints make no zones, with the name of
/// the block
BlockElement element_of(int block, const BlockSpec& spec)
{
    try {
        return block_element(spec);
    } catch (const std::invalid_argument& bad) {
        throw std::invalid_argument(name_of(block) + ": " + bad.what());
    }
}

/// Faces of each block, in the order of the layout.
std::vector<std::vector<int>> faces_by_block(const Layout& layout)
{
    std::vector<std::vector<int>> faces(layout.blocks.size());
    for (std::size_t f = 0; f < layout.faces.size(); ++f)
        for (const int block : {layout.faces[f].a, layout.faces[f].b})
            if (block != kGround) faces[block].push_back(static_cast<int>(f));
    return faces;
}

/// Blocks longer or higher than this many half units begin their modes with pure bending [-]:
/// whole units and stones do, the halves of a cracked unit do not where they are no higher than
/// long. Why, and what it does to walls: docs/model.md, section 2.
constexpr double kBendsFrom = 1.25;

bool begins_with_bending(const Block& b, const Layout& layout)
{
    return std::max(b.x1 - b.x0, b.z1 - b.z0) > kBendsFrom * layout.half_unit;
}

/// @param faces of the block, indices in Layout::faces
BlockSpec spec_of(int block, const std::vector<int>& faces, const Model& m,
                  const Discretisation& d)
{
    const Block& b = m.layout.blocks[block];
    const bool is_beam = block == m.layout.beam;
    BlockSpec s;
    s.width = b.x1 - b.x0;
    s.height = b.z1 - b.z0;
    for (const Point p : b.outline) s.outline.push_back({p.x - b.x0, p.z - b.z0});
    s.thickness = m.layout.thickness;
    s.material = stone_of(m, block, m.stone);
    if (b.between_cracks) s.material = between_cracks(s.material, m.layout.crack_rigidity);
    s.motion = motion_of(m.layout, m.loads.pattern, block);
    s.load_height = m.loads.height - b.z0;
    s.rotation_fixed = is_beam && m.beam.rotation == BeamRotation::fixed;
    s.face_rule = d.face_rule;
    s.zones_per_interval = d.zones_per_interval;
    s.zone_size = m.layout.half_unit / ((d.contact_points - 1) * d.zones_per_interval);
    s.modes = is_beam ? d.beam_modes : d.block_modes;
    s.begins_with_bending = !is_beam && begins_with_bending(b, m.layout);
    for (const int face : faces) {
        const Face& f = m.layout.faces[face];
        const auto [kn, ks] = reference_of(m, f);
        s.edges.push_back({{f.from.x - b.x0, f.from.z - b.z0},
                           {f.to.x - b.x0, f.to.z - b.z0},
                           points_of(f, m.layout, d),
                           kn,
                           ks});
    }
    return s;
}

void place_blocks(const Discretisation& d, Model& m)
{
    const std::vector<std::vector<int>> faces = faces_by_block(m.layout);
    std::vector<std::vector<double>> keys;
    for (int block = 0; block < static_cast<int>(m.layout.blocks.size()); ++block) {
        if (faces[block].empty())
            throw std::invalid_argument(name_of(block) +
                                        " touches no other and stands on no joint");
        const BlockSpec spec = spec_of(block, faces[block], m, d);
        const std::vector<double> key = key_of(spec);
        const auto known = std::find(keys.begin(), keys.end(), key);
        const int element = static_cast<int>(known - keys.begin());
        if (known == keys.end()) {
            keys.push_back(key);
            m.elements.push_back(element_of(block, spec));
        }
        m.places.push_back({element, m.n_points, m.n_modes});
        m.n_points += static_cast<int>(m.elements[element].points.size());
        m.n_modes += static_cast<int>(m.elements[element].phi.cols());
    }
    m.ground_point = m.n_points;
}

int point_of(const Model& m, int block, Point at)
{
    if (block == kGround) return m.ground_point;
    const Block& b = m.layout.blocks[block];
    const BlockPlace& place = m.places[block];
    return place.first_point +
           find_point(m.elements[place.element], {at.x - b.x0, at.z - b.z0});
}

std::vector<Contact>& list_of(const Face& f, Model& m)
{
    const bool unit_joint = f.kind == FaceKind::bed_joint || f.kind == FaceKind::head_joint;
    if (f.kind == FaceKind::unit_crack || (unit_joint && m.layout.mortar)) return m.cracks;
    const bool tied = f.kind == FaceKind::beam_joint && m.beam.interface == BeamInterface::tied;
    return tied ? m.tied : m.dry;
}

int material_of(const Layout& layout, const Face& f)
{
    const bool bonded = f.kind == FaceKind::bed_joint || f.kind == FaceKind::head_joint;
    if (bonded && layout.mortar) return layout.n_cracks + f.id - 1;
    if (f.kind == FaceKind::base_joint) return kBaseMaterial;
    if (f.kind == FaceKind::beam_joint) return kBeamMaterial;
    return f.id - 1;
}

void connect(const Discretisation& d, Model& m)
{
    for (std::size_t i = 0; i < m.layout.faces.size(); ++i) {
        const Face& f = m.layout.faces[i];
        const FacePoints points = points_of(f, m.layout, d);
        const double dx = f.to.x - f.from.x, dz = f.to.z - f.from.z,
                     length = std::hypot(dx, dz);
        for (std::size_t k = 0; k < points.position.size(); ++k) {
            const Point at{f.from.x + points.position[k] * dx,
                           f.from.z + points.position[k] * dz};
            list_of(f, m).push_back({point_of(m, f.a, at), point_of(m, f.b, at), f.normal.x,
                                     f.normal.z, points.weight[k] * length * m.layout.thickness,
                                     material_of(m.layout, f), static_cast<int>(i)});
        }
    }
}

void check(const Layout& layout, const Elastic& stone, const Beam& beam, const Loads& loads,
           const ReferenceStiffness& reference, const Discretisation& d)
{
    const auto require = [](bool ok, const char* what) {
        if (!ok) throw std::invalid_argument(what);
    };
    const double top = layout.height;
    require(layout.thickness > 0 && layout.half_unit > 0 && layout.course_height > 0,
            "a wall needs positive sizes");
    require(beam.height > 0 || !beam.present, "beam height must be positive");
    const bool driven = loads.pattern == LoadPattern::beam;
    require(beam.present || !driven, "without a beam a wall is pushed by body forces only");
    require(beam.present || loads.vertical_stress == 0.0,
            "without a beam there is nothing for the vertical stress to act on");
    require(driven || beam.rotation == BeamRotation::free,
            "body forces move the beam with the wall: its rotation cannot be fixed");
    const bool heavy = stone.density > 0 || (beam.present && beam.material.density > 0);
    require(driven || (heavy && loads.gravity > 0),
            "body forces are in proportion to weight: density and gravity must be positive");
    std::vector<Elastic> all = layout.stones;
    all.push_back(stone);
    if (beam.present) all.push_back(beam.material);
    for (const Elastic& m : all)
        require(m.young_modulus > 0 && m.poisson_ratio >= 0 && m.poisson_ratio < 0.5 &&
                    m.density >= 0,
                "elastic: E > 0, Poisson's ratio in [0, 0.5), density >= 0");
    const bool shares = std::ranges::any_of(layout.blocks, &Block::between_cracks);
    require(!shares || layout.crack_rigidity > 1.0, "cracks must be stiffer than the stone");
    require(!shares || between_cracks(stone, layout.crack_rigidity).poisson_ratio < 0.5,
            "units divided into pieces need a Poisson's ratio below 0.5 (1 - 1/rigidity)");
    require(loads.vertical_stress >= 0 && loads.gravity >= 0,
            "vertical stress and gravity must not be negative");
    require(!driven || (loads.height >= top - 1e-9 && loads.height <= top + beam.height + 1e-9),
            "the load line must lie within the beam");
    require(reference.joint.kn > 0 && reference.joint.ks > 0,
            "the reference stiffness of the joints must be positive");
    require(layout.n_cracks == 0 || (reference.crack.kn > 0 && reference.crack.ks > 0),
            "the reference stiffness of the cracks must be positive");
    require(d.contact_points >= 2 && d.zones_per_interval >= 1,
            "at least 2 contact points and 1 zone");
    for (const int modes : {d.block_modes, d.beam_modes})
        require(modes == 0 || modes >= 3, "modes: 0 (all) or at least 3 (rigid)");
}

} // namespace

std::size_t contact_count(const Face& f, const Layout& layout, const Discretisation& d)
{
    const double length = std::hypot(f.to.x - f.from.x, f.to.z - f.from.z);
    const double interval = layout.half_unit / (d.contact_points - 1);
    return static_cast<std::size_t>(std::max(1L, std::lround(length / interval))) + 1;
}

std::size_t contact_count(const Layout& layout, const Discretisation& d)
{
    std::size_t n = 0;
    for (const Face& f : layout.faces) n += contact_count(f, layout, d);
    return n;
}

Model discretise(Layout layout, const Elastic& stone, const Beam& beam, const Loads& loads,
                 const ReferenceStiffness& reference, const Discretisation& d)
{
    check(layout, stone, beam, loads, reference, d);
    Model m;
    m.beam = beam;
    m.loads = loads;
    m.stone = stone;
    m.reference = reference;
    m.layout = std::move(layout);
    place_blocks(d, m);
    connect(d, m);
    return m;
}

Model discretise(const WallGeometry& wall, const Elastic& stone, const Beam& beam,
                 const Loads& loads, const ReferenceStiffness& reference,
                 const Discretisation& d)
{
    return discretise(lay_out(wall, beam.present ? beam.height : 0.0), stone, beam, loads,
                      reference, d);
}

FaceStiffness reference_of(const Model& m, const Face& f)
{
    if (f.kind != FaceKind::unit_crack) return {m.reference.joint.kn, m.reference.joint.ks};
    const double own =
        own_stiffness(m.layout, static_cast<std::size_t>(f.id - 1)) * m.stone.young_modulus;
    if (own > 0.0) return {own, own};
    return {m.reference.crack.kn, m.reference.crack.ks};
}

const Elastic& stone_of(const Model& m, int block, const Elastic& stone)
{
    return stone_of(m.layout, block, stone, m.beam.material);
}

bool is_supported(const Model& m, int block)
{
    return block != m.layout.beam && m.layout.blocks[block].motion != Motion::free;
}

} // namespace dem

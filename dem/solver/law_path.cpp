#include "dem/solver/law_path.hpp"

#include "dem/solver/state/closing_joint.hpp"
#include "dem/solver/step/crack_kernels.hpp"

namespace dem {
namespace {

/// The start and the point after each move. `step` sets sigma, tau and damage of a point.
template <class Step> std::vector<LawPoint> path_of(std::span<const LawMove> moves, Step step)
{
    std::vector<LawPoint> path;
    path.reserve(moves.size() + 1);
    LawPoint at;
    path.push_back(at);
    for (const LawMove& m : moves) {
        at.u_n += m.du_n;
        at.u_s += m.du_s;
        step(m, at);
        path.push_back(at);
    }
    return path;
}

} // namespace

std::vector<LawPoint> crack_path(const CrackMaterial& crack, const CrackLaws& choice,
                                 std::span<const LawMove> moves)
{
    LaneLaws<double> laws;
    laws.cracks = {crack_law(crack)};
    if (choice.mixed_mode) laws.mixed = {mixed_law(crack)};
    laws.unloading = choice.unloading;
    std::vector<LawPoint> path;
    with_crack_law(choice.law, laws, [&]<class Law>() {
        const Law law(laws, 0);
        CrackState<double> s = choice.unloading == Unloading::secant
                                   ? intact<Unloading::secant>(laws.cracks[0])
                                   : intact<Unloading::elastic>(laws.cracks[0]);
        path = path_of(moves, [&](const LawMove& m, LawPoint& at) {
            s = law.advance(s, m.du_n, m.du_s).state;
            at.sigma = s.sigma;
            at.tau = s.tau;
            at.damage = damage(laws.cracks[0], s);
        });
    });
    return path;
}

std::vector<LawPoint> joint_path(const JointMaterial& joint, Closure closure,
                                 std::span<const LawMove> moves)
{
    if (closure == Closure::linear) {
        const DryLaw<double> law{joint.kn, joint.ks, 1.0 / joint.ks, joint.tan_phi};
        DryState<double> s{};
        return path_of(moves, [&](const LawMove& m, LawPoint& at) {
            const DryUpdate<double> u = advance(law, s, m.du_n, m.du_s);
            s = u.state;
            at.sigma = u.sigma;
            at.tau = s.tau;
        });
    }
    const Closing& c = joint.closing;
    const ClosureLaw<double> law = closure_law(closure, c.initial_stiffness, c.maximum,
                                               c.stiffest, c.loss, joint.ks / joint.kn);
    LaneLaws<double> laws;
    laws.closure = closure;
    laws.loses = c.loss > 0.0;
    std::vector<LawPoint> path;
    with_closure(laws, [&]<Closure kClosure, bool kLoses>() {
        ClosingState<double> s{};
        path = path_of(moves, [&](const LawMove& m, LawPoint& at) {
            const ClosingUpdate<double> u =
                advance_closing<kClosure, kLoses>(law, joint.tan_phi, s, m.du_n, m.du_s);
            s = u.state;
            at.sigma = u.sigma;
            at.tau = u.tau;
        });
    });
    return path;
}

} // namespace dem

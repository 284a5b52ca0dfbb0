#pragma once
/// Small studies with distributions.

#include "app/input/prepared_study.hpp"
#include "app/input/study_reading.hpp"

#include <string>

namespace study_scenes {

inline const char* const kSmall = R"([wall]
length = 0.60 m
courses = 4
course_height = 0.10 m
unit_length = 0.20 m
thickness = 0.20 m
[stone]
young_modulus = 15.5 GPa
poisson_ratio = 0.2
density = 2300 kg/m3
[joint]
wall_modulus = 768, 1057 MPa
friction_angle = normal(mean 31.8 deg, cov 0.20)
stiffness_factor = normal(mean 1, cov 0.25)
[unit]
tensile_strength = lognormal(mean 3.7 MPa, cov 0.30)
fracture_energy = 110 N/m
friction_angle = normal(mean 35 deg, cov 0.20)
stiffness_factor = normal(mean 1, cov 0.25)
[beam]
height = 0.10 m
young_modulus = 30 GPa
density = 2400 kg/m3
[load]
vertical_stress = 0.50, 1.00 MPa
max_displacement = 4 mm
[solver]
fidelity = simple
)";

inline app::Study study(const std::string& uq, const std::string& text = kSmall)
{
    return app::prepare(
               app::read_study(app::parse_study_text("study.ini", text + "[uq]\n" + uq)))
        .study;
}

} // namespace study_scenes

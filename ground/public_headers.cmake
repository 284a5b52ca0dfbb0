# Installed with the library. The other headers are its own business.
set(GROUND_PUBLIC_HEADERS
    ground_motion.hpp
    intensity.hpp
    motion_facts.hpp
    oscillator.hpp
    pulse.hpp
    record.hpp
    record_error.hpp
    stochastic_motion.hpp)

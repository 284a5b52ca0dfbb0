# Installed with the library. The other headers are its own business.
set(DEM_PUBLIC_HEADERS
    block/block_element.hpp
    block/block_spec.hpp
    block/discretisation.hpp
    block/face_rule.hpp
    block/model.hpp
    contact/contact_options.hpp
    scene/layout.hpp
    scene/mechanism.hpp
    scene/paper_materials.hpp
    scene/snapshot.hpp
    scene/wall.hpp
    solver/curve_point.hpp
    solver/energy.hpp
    solver/ensemble.hpp
    solver/push.hpp
    solver/solver_options.hpp)

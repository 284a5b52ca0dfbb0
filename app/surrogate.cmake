drystone_app_library(surrogate
    surrogate/learned_surrogate.cpp
    surrogate/mode_surrogate.cpp
    surrogate/surrogate_command.cpp
    surrogate/surrogate_data.cpp
    surrogate/surrogate_fit.cpp
    surrogate/surrogate_json.cpp
    surrogate/surrogate_study.cpp
    surrogate/surrogate_tables.cpp)
target_link_libraries(drystone_app_surrogate
    PUBLIC drystone_app_study drystone_uq_surrogates
    PRIVATE nlohmann_json::nlohmann_json)

#pragma once
/// Evaluations on disk while an analysis runs, so that the next one continues with them after
/// Ctrl-C or a kill.
///
/// The file has a line of JSON for each evaluation, after one that says what the model is.
/// Remove it when the answer is there: what another program answers today need not be what it
/// answers tomorrow.

#include "uq/reliability/limit_state/black_box.hpp"

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace uq {

class KeptEvaluations {
  public:
    struct OtherModel : std::invalid_argument {
        OtherModel(const std::string& what, std::string kept)
            : std::invalid_argument(what), model(std::move(kept))
        {
        }
        std::string model; ///< of the file
    };

    /// Reads what an interrupted run has left. A last line that a kill has cut off is dropped.
    /// @param model what the answers depend on, in words
    /// @throws OtherModel if the file is that of another model; std::runtime_error if it is
    /// damaged or
    /// cannot be written
    KeptEvaluations(std::filesystem::path file, const std::string& model);

    /// Thrown by the model of around() where the disk takes no more. It is not a
    /// std::exception, because that would be a failed sample.
    struct NotKept {
        std::string what; ///< names the file
    };

    /// Evaluations that were there at the start.
    [[nodiscard]] std::size_t found() const { return found_; }

    /// Wraps the model: evaluates only unknown samples, in small batches, and stores each
    /// batch.
    /// @param response the column that is kept; the only one of the answers
    /// The model that is returned must not outlive this.
    [[nodiscard]] BlackBox around(BlackBox model, Eigen::Index response);

    /// Removes the file, because the answer is there.
    void remove();

  private:
    struct Answer {
        double y;
        std::string failure;
    };
    void keep(const std::vector<double>& x, const Answer& answer);

    std::filesystem::path file_;
    std::ofstream out_;
    std::map<std::vector<double>, Answer> known_;
    std::size_t found_ = 0;
};

} // namespace uq

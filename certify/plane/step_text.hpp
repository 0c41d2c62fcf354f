// Steps of a certificate as JSON (docs/certificates.md).
#pragma once

#include <string>

#include "certify/plane/sum_proof.hpp"

namespace minkref::certify {

/// `pieces` of an operand, "P" or "Q".
std::string pieces_text(const PieceTree& tree, const std::string& operand);

/// `eq`, or `move` for a proof over two scales; `by`: the numbers of the steps on the pieces.
std::string sum_text(const SumProof& proof, std::size_t pieces_of_P, std::size_t pieces_of_Q);

}  // namespace minkref::certify

#pragma once
/// Whether two variants of a trial differ by more than chance, over the same seeds.

#include <cstddef>
#include <vector>

namespace aisle {

/// The bounds of a confidence interval.
struct Confidence {
  double low = 0, high = 0;
};

/// The 95 % score interval of a share (Wilson 1927); 0 to 1 if `trials` is 0.
Confidence wilson_interval(std::size_t successes, std::size_t trials);

/// The two-sided exact test of paired yes and no (McNemar 1947): the chance that pairs which differ are split
/// at least as unevenly as these, if each may go either way.
/// @param only_first, only_second  pairs in which only the one or only the other went well
double mcnemar_p(std::size_t only_first, std::size_t only_second);

/// The two-sided sign-flip test (Fisher 1935): the chance of a mean at least so far from 0 if each difference
/// were as likely to have the other sign. All sign patterns of up to 14 differences, 20,000 random ones of
/// more.
double sign_flip_p(const std::vector<double>& differences);

/// The 95 % interval of the mean, by the bootstrap (Efron 1979) with 4,000 fixed draws; of one value: itself.
Confidence bootstrap_interval(const std::vector<double>& values);

/// The chances of several tests, each raised so that 0.05 bounds the chance that any of them is wrong (Holm
/// 1979). In their order, at most 1.
std::vector<double> holm_adjusted(const std::vector<double>& p);

}  // namespace aisle

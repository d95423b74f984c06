// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mpfr.h>

namespace dgt {

/// Owns one MPFR number; converts to the handle that MPFR's functions take.
class MpfrFloat {
 public:
  explicit MpfrFloat(mpfr_prec_t bits) { mpfr_init2(value_, bits); }
  ~MpfrFloat() { mpfr_clear(value_); }
  MpfrFloat(const MpfrFloat&) = delete;
  MpfrFloat& operator=(const MpfrFloat&) = delete;

  operator mpfr_ptr() { return value_; }           // NOLINT: a drop-in handle by design
  operator mpfr_srcptr() const { return value_; }  // NOLINT

 private:
  mpfr_t value_;
};

}  // namespace dgt

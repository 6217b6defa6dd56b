#include <erfam.h>

#include <vectrix/frames/dcm_doors.hpp>
#include <vectrix/space/earth/eme2000.hpp>

#include "erfa_rotation.hpp"

namespace vectrix {

Dcm<earth::Eme2000, earth::Gcrf> eme2000_from_gcrf() {
  detail::Rows bias, precession, both;
  eraBp06(ERFA_DJ00, 0.0, bias, precession, both);
  return trust_dcm(to<earth::Eme2000>, from<earth::Gcrf>, Eigen::Matrix3d(detail::matrix_of(bias)));
}

}  // namespace vectrix

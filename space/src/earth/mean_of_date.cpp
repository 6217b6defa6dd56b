#include <vectrix/frames/dcm_doors.hpp>
#include <vectrix/space/earth/mean_of_date.hpp>

#include "../time/near_j2000.hpp"
#include "erfa_rotation.hpp"

namespace vectrix {

Dcm<earth::MeanOfDate, earth::Gcrf> mean_of_date_from_gcrf(const Epoch& epoch) {
  detail::require_near_j2000({"mean_of_date_from_gcrf"}, epoch);
  const JulianDate tt = epoch.tt_date();
  detail::Rows rows;
  eraPmat06(tt.day, tt.fraction, rows);
  return trust_dcm(to<earth::MeanOfDate>, from<earth::Gcrf>, Eigen::Matrix3d(detail::matrix_of(rows)));
}

}  // namespace vectrix

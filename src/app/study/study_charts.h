// app/study: the charts of one scene.
#pragma once

#include <string>
#include <vector>

#include "app/study/chart.h"
#include "app/study/study.h"

namespace alhazen {

// The id of the pictures of each point, "p0", "p1", ...: points of one picture share one.
std::vector<std::string> picture_ids(const SceneStudy& study);

// Everything, with the front and the slopes; as wide as a desk's screen or as a phone's.
Chart main_chart(const SceneStudy& study, bool narrow);

struct KnobChart {
  Knob knob;
  std::string heading, remark;
  Chart chart;
};
// One for each knob of this renderer with at least two points, the others in the background.
std::vector<KnobChart> knob_charts(const SceneStudy& study);

// What `point` is, in a line: settings, error, time.
std::string point_text(const SceneStudy& study, const StudyPoint& point);

}  // namespace alhazen

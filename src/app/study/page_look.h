// app/study: the style sheet and the script of a study's page.
#pragma once

#include "app/page/page.h"

namespace alhazen {

PageExtras study_page_extras();

}  // namespace alhazen

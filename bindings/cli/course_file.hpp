// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "base/result.hpp"
#include "records/lessons.hpp"

namespace rhexis::cli {

/// name: a file, or the name of one in root/courses. Fails also where a lesson's exercise is not there.
Result<records::LessonPlan> read_course(const std::string& name, const std::string& root);

/// The course that is named, or that RHEXIS_COURSE names; "": none.
std::string course_named(const std::string& given);

/// The same; where neither names one it is cataract.
Result<records::LessonPlan> read_course_or_usual(const std::string& given, const std::string& root);

}  // namespace rhexis::cli

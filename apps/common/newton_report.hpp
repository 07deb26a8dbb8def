#pragma once

#include "common/report_json.hpp"

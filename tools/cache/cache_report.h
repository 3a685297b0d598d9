// What a study of caches found: tables for people, and CSV with the counts alone.

#pragma once

#include "tools/cache/cache_study.h"

#include <string>

namespace ffgpu::tools {

// Of a curve: "texel, blocked, tiled 8".
std::string variant_name(const CurveResult& curve);

std::string cache_tables(const CacheStudyOptions& options, const CacheStudyResult& result);

// A row for each cache: docs/cache.md names the columns.
std::string curves_csv(const CacheStudyOptions& options, const CacheStudyResult& result);
// A row for each frame: the different lines that it looks up.
std::string working_sets_csv(const CacheStudyResult& result);

} // namespace ffgpu::tools

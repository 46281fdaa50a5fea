# RAILPEM_PROCESSOR: the value for -march that RAILPEM_MARCH asks for, as far as the compiler knows it; empty: its default.
# RAILPEM_PROCESSOR_FITS: asks at run time whether a machine has it, in C++; empty where nobody can tell.
include(CheckCXXCompilerFlag)
include(CheckCXXSourceRuns)

set(features_of_x86-64-v3 avx2 fma bmi2)
set(features_of_x86-64-v4 ${features_of_x86-64-v3} avx512f avx512bw avx512cd avx512dq avx512vl)

# In C++: whether a machine has all FEATURES, as __builtin_cpu_supports names them.
function(railpem_asks_for result)
  list(TRANSFORM ARGN REPLACE "(.+)" "__builtin_cpu_supports(\"\\1\")" OUTPUT_VARIABLE asked)
  list(JOIN asked "&&" asked)
  set(${result} "${asked}" PARENT_SCOPE)
endfunction()

# Whether the machine that configures has them. Other processor families have none of them.
function(railpem_machine_has result)
  railpem_asks_for(asked ${ARGN})
  check_cxx_source_runs("int main() { return ${asked} ? 0 : 1; }" ${result})
endfunction()

set(RAILPEM_PROCESSOR "${RAILPEM_MARCH}")
if(RAILPEM_MARCH STREQUAL "this-machine")
  set(RAILPEM_PROCESSOR "")
  if(NOT CMAKE_CROSSCOMPILING)
    railpem_machine_has(RAILPEM_MACHINE_HAS_V3 ${features_of_x86-64-v3})
    railpem_machine_has(RAILPEM_MACHINE_HAS_V4 ${features_of_x86-64-v4})
    if(RAILPEM_MACHINE_HAS_V4)
      set(RAILPEM_PROCESSOR x86-64-v4)
    elseif(RAILPEM_MACHINE_HAS_V3)
      set(RAILPEM_PROCESSOR x86-64-v3)
    endif()
  endif()
endif()
if(RAILPEM_PROCESSOR)
  check_cxx_compiler_flag(-march=${RAILPEM_PROCESSOR} RAILPEM_KNOWS_${RAILPEM_PROCESSOR})
  if(NOT RAILPEM_KNOWS_${RAILPEM_PROCESSOR})
    set(RAILPEM_PROCESSOR "")
  endif()
endif()
railpem_asks_for(RAILPEM_PROCESSOR_FITS ${features_of_${RAILPEM_PROCESSOR}})

# The lists of effects, written from the files that are there: effects/catalogue/rail_shear.cpp describes one effect in
# the function effects::rail_shear(), diagnosis/effects/rail_shear.cpp has what it does to the model, and
# simulate/effects/rail_shear.cpp what it does to the world that is marched. A new file is a new effect; no list is edited.

# railpem_effects_list(TARGET DESCRIBED|IN_MODEL|HIDDEN ROOTS folder...): adds one of the three lists to TARGET. A root is
# a folder that has effects/catalogue, diagnosis/effects and simulate/effects.
function(railpem_effects_list target kind)
  cmake_parse_arguments(LIST "" "" "ROOTS" ${ARGN})
  set(declared "")
  set(listed "")
  foreach(root ${LIST_ROOTS})
    file(GLOB files CONFIGURE_DEPENDS ${root}/effects/catalogue/*.cpp)
    foreach(file ${files})
      cmake_path(GET file STEM name)
      string(REPLACE "_" "-" id ${name})
      if(kind STREQUAL "DESCRIBED")
        string(APPEND declared "EffectDescription ${name}();\n")
        string(APPEND listed "        ${name}(),\n")
      elseif(kind STREQUAL "IN_MODEL" AND EXISTS ${root}/diagnosis/effects/${name}.cpp)
        string(APPEND declared "EffectInModel ${name}();\n")
        string(APPEND listed "        {\"${id}\", ${name}()},\n")
      elseif(kind STREQUAL "HIDDEN" AND EXISTS ${root}/simulate/effects/${name}.cpp)
        string(APPEND declared "void hide_${name}(const HiddenValues&, HiddenTarget);\n")
        string(APPEND listed "        {\"${id}\", hide_${name}},\n")
      endif()
    endforeach()
  endforeach()
  if(kind STREQUAL "DESCRIBED")
    set(folder effects)
    set(header effects/catalogue.hpp)
    set(function "std::vector<EffectDescription> described_effects()")
  elseif(kind STREQUAL "IN_MODEL")
    set(folder diagnosis)
    set(header diagnosis/effects/effect.hpp)
    set(function "std::map<std::string, EffectInModel> effects_in_model()")
  else()
    set(folder simulate)
    set(header simulate/effects/hidden_effects.hpp)
    set(function "std::map<std::string, HideInWorld> effects_in_world()")
  endif()
  set(output ${CMAKE_CURRENT_BINARY_DIR}/${folder}_list.cpp)
  file(CONFIGURE OUTPUT ${output} @ONLY CONTENT "// Written by scripts/effects.cmake from the files that are there.
#include \"@header@\"

namespace railpem::@folder@ {

@declared@
@function@ {
    return {
@listed@    };
}

}  // namespace railpem::@folder@
")
  # Alone in its object file, so that a program with a longer list takes that in its place.
  set_source_files_properties(${output} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  target_sources(${target} PRIVATE ${output})
endfunction()

# What is otherwise in a handout. The text of its judge is packed, so that nobody reads an answer there by
# accident. It is no secret (tests/what-protects-a-grade.md).

# make unpacks it first, and then reads its rules.
ifneq ($(filter-out setup doctor help clean,$(or $(MAKECMDGOALS),all)),)
$(BUILD)/judge/judge.mk: tests/judge/judge.tar | $(BUILD)/ready
	@rm -rf $(@D) && mkdir -p $(@D) && tar -xmf $< -C $(@D)
include $(BUILD)/judge/judge.mk
endif

# The first `make grade` says how far it is, and not what it compiles: on a terminal in one line, else now and then.
ONCE_OBJECTS = $(call objects,$(filter-out %/sandbox_init_tool.c,$(GRADER_MAINS)) $(GRADER_SOURCES) $(wildcard common/*.c common/*.cpp) \
    tests/probes/$(graded_lab)/main.c $(addprefix tests/probes/,find_device.c probe.c probe_host.c probe_trees.c sections.c) \
    $(call earlier_sources,$(graded_lab)) $(if $(SUBMISSION),,$(DESK_SOURCES))) \
    $(lab_judge:$(OUT)/%=$(OUT)/obj/%.o) $(call judge_objects,$(graded_lab))
ONCE_RACES = $(filter $(RACES),$(lab_grader))
ONCE = $(filter-out %.a,$(lab_grader)) $(if $(SUBMISSION),,$(OUT)/tools/desk) \
    $(filter $(OUT)/probes/$(graded_lab).o,$(PROBES:%=%.o)) \
    $(OUT)/libimage_codec.so $(SANDBOX_INIT) $(ONCE_OBJECTS) $(if $(ONCE_RACES),$(call objects,tests/probes/$(graded_lab)/race.c \
    $(filter-out %/main.c,$(wildcard labs/$(graded_lab)/*.c))))
ifeq ($(MAKECMDGOALS)$(wildcard $(OUT)/tools/grade),grade)
N_ONCE := $(words $(filter-out $(wildcard $(ONCE)),$(sort $(ONCE))))
steps =
step = $(eval steps += 1)$(words $(steps))
far = building the course once: $(1) of $(N_ONCE)
progress = if [ -t 1 ]; then printf '\r  %s$(if $(filter $(N_ONCE),$(1)),\n)' '$(far)'; else $(if $(filter %0 $(N_ONCE),$(1)),echo '  $(far)',:); fi
say = $(if $(V),,@$(call progress,$(step)) && )
endif

# What is otherwise in a handout. The judge is a program already.

$(OUT)/tools/judge: tests/judge/judge-$(shell uname -m)
	@mkdir -p $(@D)
	@cp $< $@

# The grader grades one submission after the other, by hand: to optimise it would take longer than it saves.
$(OUT)/obj/tests/grader/%.o $(OUT)/obj/tests/desk/%.o: OPTIMISATION = -O0 -g

# The first `make grade` says how far it is, and not what it compiles: on a terminal in one line, else now and then.
ONCE_OBJECTS = $(call objects,$(filter-out %/sandbox_init_tool.c,$(GRADER_MAINS)) $(GRADER_SOURCES) $(wildcard common/*.c common/*.cpp) \
    tests/probes/$(graded_lab)/main.c $(addprefix tests/probes/,find_device.c probe.c probe_host.c probe_trees.c sections.c) \
    $(call earlier_sources,$(graded_lab)) $(if $(SUBMISSION),,$(DESK_SOURCES)))
ONCE_RACES = $(filter $(RACES),$(lab_grader))
ONCE = $(filter-out %/judge %.a,$(lab_grader)) $(if $(SUBMISSION),,$(OUT)/tools/desk) \
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

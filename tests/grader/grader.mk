# How the grader is built, in the course and in a handout: its library, its programs, the probes.
# Included by the top folder's Makefile, whose variables it uses.

GRADER_ROOMS := tests/grader $(patsubst %/,%,$(wildcard tests/grader/*/))
GRADER_MAINS := tests/grader/grade.c tests/grader/submission/unpack_tool.c tests/grader/sandbox/sandbox_init_tool.c
GRADER_SOURCES := $(filter-out $(GRADER_MAINS),$(foreach room,$(GRADER_ROOMS),$(wildcard $(room)/*.c)))
PROBE_FOLDERS := tests/probes $(sort $(dir $(wildcard tests/probes/*/jobs_*.h)))
GRADER_INCLUDES = $(addprefix -I ,$(GRADER_ROOMS) $(PROBE_FOLDERS)) $(AUTHORS_INCLUDES)
$(OUT)/obj/tests/%.o: EXTRA = $(GRADER_INCLUDES)
# The grader waits for what it starts: to optimise it takes longer than it saves.
$(OUT)/obj/tests/grader/%.o $(OUT)/obj/tests/desk/%.o: OPTIMISATION = -O0 -g

$(OUT)/libgrader.a: $(call objects,$(GRADER_SOURCES) tests/probes/sections.c)
	$(archive)
$(OUT)/tools/grade: $(call objects,tests/grader/grade.c) $(OUT)/libgrader.a $(OUT)/libcommon.a | $(OUT)/libimage_codec.so
	$(call link,$(LIBRARIES))
# The only program that reads archives of students, in the sandbox.
$(OUT)/tools/unpack: $(call objects,tests/grader/submission/unpack_tool.c) $(OUT)/libgrader.a $(OUT)/libcommon.a
	$(call link,$(LIBRARIES) -larchive)

# Process 1 of bubblewrap's sandboxes is a program of its own, whose bytes the grader holds; never with
# the sanitizers.
SANDBOX_INIT := $(OUT)/obj/tests/grader/sandbox/sandbox_init
$(SANDBOX_INIT): tests/grader/sandbox/sandbox_init_tool.c $(FLAG_FILES)
	@mkdir -p $(@D)
	$(call say,link    $@)$(CC) -std=c11 -D_GNU_SOURCE -O2 -s $(WARNINGS) $< -o $@
$(SANDBOX_INIT).c.o: EXTRA = $(GRADER_INCLUDES) -DSANDBOX_INIT='"$(SANDBOX_INIT)"'
$(SANDBOX_INIT).c.o: $(SANDBOX_INIT)

# One probe a lab: an object for labs with host files, which the grader links with the student's, and a
# program for the others. The object holds all that the probe calls but the student's functions, the C
# library's and the driver's, with its own copies of functions of the labs before and of common/. None of
# these has a name for the linker: a student's function of the same name is another one, and neither
# replaces the other. What keeps its name is main(), and what is to replace a function of the driver's:
# defined once more, it is an error.
PROBED := $(patsubst tests/probes/%/main.c,%,$(wildcard tests/probes/*/main.c))
WITH_HOST_FILES := $(patsubst labs/%/lab.json,%,$(shell LC_ALL=C grep -l '"[a-zA-Z0-9_]*\.c"' labs/*/lab.json))
PROBES := $(PROBED:%=$(OUT)/probes/%.o) $(addprefix $(OUT)/probes/,$(filter-out $(WITH_HOST_FILES),$(PROBED)))
$(OUT)/obj/tests/probes/%/main.c.o: EXTRA = $(PROBE_FOLDERS:%=-I %) -I labs/$(lab_name) -DLAB_NAME='"$(lab_name)"' \
    -DLAB_FOLDER='"labs/$(lab_name)"' -DPROBE_KERNEL_OPTIONS='"$(call include_path,$(lab_name))"'
$(OUT)/probes/%.o: $(OUT)/obj/tests/probes/%/main.c.o $(call objects,$(addprefix tests/probes/,probe.c probe_host.c probe_trees.c sections.c)) \
    $(OUT)/earlier/%.a $(OUT)/libcommon.a
	@mkdir -p $(@D)
	$(call say,link    $@)ld -r $(filter %.o,$^) --start-group $(filter %.a,$^) --end-group -o $@ && \
	    objcopy --wildcard --keep-global-symbol=main --keep-global-symbol='cl[A-Z]*' $@
$(OUT)/probes/%: $(OUT)/probes/%.o
	$(call link,-lOpenCL -lm)

# What a student's kernel has made a macro is none in a probe.
$(OUT)/no_macros.h: tests/probes/no_macros.sh tests/probes/probe_stack.h $(wildcard tests/probes/*/probe.cl) $(wildcard kernels/*.h labs/*/*.h solutions/*/*.h tests/probes/*.h)
	@mkdir -p $(@D)
	$(call say,make    $@)sh $< >$@

# Of a lab with a leaderboard: a race between an earlier lab's kernel and the one that was handed in. It
# holds what the lab gives its students, whose answers are kernels.
RACES := $(patsubst tests/probes/%/race.c,$(OUT)/probes/%-race,$(wildcard tests/probes/*/race.c))
$(OUT)/obj/tests/probes/%/race.c.o: EXTRA = $(PROBE_FOLDERS:%=-I %) -I labs/$(lab_name) $(call include_path,$(lab_name)) \
    -DLAB_FOLDER='"labs/$(lab_name)"' -DPROBE_KERNEL_OPTIONS='"$(call include_path,$(lab_name))"'
$(RACES): $(OUT)/probes/%-race: $(OUT)/obj/tests/probes/%/race.c.o $(call objects,tests/probes/probe.c tests/probes/sections.c) \
    $$(call objects,$$(filter-out labs/$$*/main.c,$$(wildcard labs/$$*/*.c))) $(OUT)/earlier/%.a $(OUT)/libcommon.a
	$(call link,$(LIBRARIES))

# In a handout, which has no solution to run: is there a device?
$(OUT)/probes/find_device: $(call objects,tests/probes/find_device.c) $(OUT)/libcommon.a
	$(call link,-lOpenCL -lm)

.PHONY: grader graded lab-grader grade
grader: $(addprefix $(OUT)/tools/,grade unpack) $(OUT)/probes/find_device $(OUT)/no_macros.h $(PROBES) $(RACES) $(LABS:%=$(OUT)/earlier/%.a)  ## build the grader and its probes

# Which packages `make setup` installs (common/setup/packages.txt): what a handout needs. The course needs more.
setup_for = grade

# The name of the lab that is asked for as LAB=3, LAB=03 or by its name; empty where there is none.
graded_lab = $(if $(or $(findstring %,$(LAB)),$(word 2,$(LAB))),,$(filter $(LAB) $(LAB)-% 0$(LAB)-%,$(LABS)))
say_which_lab = test -n "$$LAB" || { echo "make $@: say which lab: make $@ LAB=$(EXAMPLE_LAB)" >&2; exit 2; }
# The grader of one lab: what a bundle for another system builds, and whoever grades.
lab_grader = $(addprefix $(OUT)/tools/,grade unpack) $(lab_judge) $(OUT)/no_macros.h \
    $(if $(wildcard solutions/$(graded_lab)/lab.json),,$(OUT)/probes/find_device) \
    $(filter $(addprefix $(OUT)/probes/,$(graded_lab) $(graded_lab).o $(graded_lab)-race),$(PROBES) $(RACES)) \
    $(patsubst %,$(OUT)/earlier/%.a,$(graded_lab))
graded: $$(lab_grader)
lab-grader: graded
	@test -n "$(graded_lab)" || { printf 'make $@: found LAB="%s", expected the number or name of a lab: $(LABS)\n' "$$LAB" >&2; exit 2; }

# Status 1 is a verdict, such as points that are missing, and no error of make.
verdict_is_no_fault = || test $$? -eq 1

# Where make can also write for other systems, through_formats is the command that does, and own_points one
# before it that makes a manifest of an instructor's POINTS (tests/tests.mk).
grade: graded $$(DESK)  ## grade LAB=03 [SUBMISSION=folder, archive or file] [SEED=n] [DEVICE=d] [TIME_LIMIT=seconds] [TASK=name | ALL=1] [POINTS=file.csv]
	@$(say_which_lab)
	$(if $(and $(FORMAT),$(graded_lab)),$(if $(through_formats),,@echo "make grade: a handout has no FORMAT: build/grade/ holds what it writes" >&2; exit 2))
	@$(own_points) $(through_formats) $(OUT)/tools/grade --build $(OUT) --lab "$$LAB" $(if $(own_points),--manifest $(OUT)/own-points.json) $(if $(SUBMISSION),--submission "$$SUBMISSION") \
	    $(if $(SEED),--seed "$$SEED") $(if $(DEVICE),--device "$$DEVICE") \
	    $(if $(TIME_LIMIT),--time-limit "$$TIME_LIMIT") \
	    $(if $(TASK),--task "$$TASK",$(if $(ALL),,--first)) $(verdict_is_no_fault)
	$(if $(SUBMISSION),,$(note_own))

# How the judges are built: a program for each lab, which is never linked with what starts a student's code.
# A handout has the folder of this file packed, and unpacks it below build/ (tests/handout/judge.mk).

JUDGE := $(patsubst %/judge.mk,%,$(lastword $(MAKEFILE_LIST)))
JUDGE_ROOMS := $(JUDGE) $(patsubst %/,%,$(wildcard $(JUDGE)/*/))
# Judges of later labs get their trees and cameras from the solutions of labs 02, 04 and 06.
BUILDERS := $(wildcard solutions/02-kdtree-2d-build/kdtree2d_build.c \
    solutions/04-camera-rays/camera_from_view.c solutions/06-kdtree-3d-build/kdtree3d_build.c)
BUILDER_INCLUDES = $(addprefix -I ,$(sort $(dir $(BUILDERS))))
AUTHORS_INCLUDES += $(addprefix -I ,$(JUDGE_ROOMS) tests/stubs) $(BUILDER_INCLUDES)
$(OUT)/obj/$(JUDGE)/%.o: EXTRA = $(GRADER_INCLUDES)
# Every ray asks every sphere, in nearly every test of a judge.
$(OUT)/obj/$(JUDGE)/oracles/%.o: OPTIMISATION = -O3 -g -fno-math-errno

# Which files each lab's judge needs, as words LAB:FILE.
JUDGE_FILES := $(shell sh $(JUDGE)/sources.sh $(JUDGE) $(BUILDERS))
judge_objects = $(call objects,$(filter %.c,$(patsubst $(1):%,%,$(filter $(1):%,$(JUDGE_FILES)))))
JUDGED := $(sort $(notdir $(patsubst %/,%,$(dir $(wildcard $(JUDGE)/[0-9]*/judge_[0-9][0-9].c)))))
JUDGES := $(JUDGED:%=$(OUT)/judges/%)
lab_judge = $(filter $(OUT)/judges/$(graded_lab),$(JUDGES))
$(OUT)/obj/judges/%.o: $(JUDGE)/judges.c $(FLAG_FILES)
	$(call compile,$(CC) $(CFLAGS) $(GRADER_INCLUDES) -D'JUDGES=JUDGE($(firstword $(subst -, ,$*)))', for $*)
$(JUDGES): $(OUT)/judges/%: $(OUT)/obj/judges/%.o $$(call judge_objects,$$*) $(OUT)/libcommon.a
	$(call link,-lm)

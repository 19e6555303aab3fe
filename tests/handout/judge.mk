# In a handout the judge is a program already.

$(OUT)/tools/judge: tests/judge/judge-$(shell uname -m)
	@mkdir -p $(@D)
	@cp $< $@

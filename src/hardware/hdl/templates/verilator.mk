# {{ title }}
# make -f {{ name }}_verilator.mk        builds the C++ harness and runs it on the vectors
# HDL=DIR says where the module is, if not here.
HDL ?= .
{%- if tables %}
TABLES = {{ tables | join(" ") }}
{%- endif %}
.PHONY: run clean
run: obj_{{ name }}/V{{ top }}{{ " $(TABLES)" if tables }}
	obj_{{ name }}/V{{ top }} {{ vectors }}
# Verilator would add -Os, which undoes -O2.
obj_{{ name }}/V{{ top }}: $(HDL)/{{ name }}.v {{ top ~ ".v " if bench }}{{ name }}_harness.cpp
	verilator --cc --exe --build -Wall {{ "--top-module " ~ top ~ " " if bench }}--Mdir obj_{{ name }} -CFLAGS "-O2" \
	    -MAKEFLAGS "OPT_FAST= OPT_SLOW= OPT_GLOBAL=" $^
{%- if tables %}
ifneq ($(HDL),.)
$(TABLES): %.hex: $(HDL)/%.hex
	cp $< $@
endif
{%- endif %}
clean:
	rm -rf obj_{{ name }}

# {{ title }}
# make -f {{ name }}_verilator.mk        builds the C++ harness and runs it on the vectors
.PHONY: run clean
run: obj_{{ name }}/V{{ name }}
	obj_{{ name }}/V{{ name }} {{ vectors }}
obj_{{ name }}/V{{ name }}: {{ name }}.v {{ name }}_harness.cpp
	verilator --cc --exe --build -Wall --Mdir obj_{{ name }} -CFLAGS "-O2" \
	    -MAKEFLAGS "OPT_FAST= OPT_SLOW= OPT_GLOBAL=" {{ name }}.v {{ name }}_harness.cpp
clean:
	rm -rf obj_{{ name }}

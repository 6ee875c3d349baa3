# tangent: tangent-space set-up of a triangle's vertex: map, view vector and lights in texture space
# make -f tangent_verilator.mk        builds the C++ harness and runs it on the vectors
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run clean
run: obj_tangent/Vtangent
	obj_tangent/Vtangent tangent_vectors.txt
# Verilator would add -Os, which undoes -O2.
obj_tangent/Vtangent: $(HDL)/tangent.v tangent_harness.cpp
	verilator --cc --exe --build -Wall --Mdir obj_tangent -CFLAGS "-O2" \
	    -MAKEFLAGS "OPT_FAST= OPT_SLOW= OPT_GLOBAL=" $^
clean:
	rm -rf obj_tangent

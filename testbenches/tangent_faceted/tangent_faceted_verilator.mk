# tangent: tangent-space set-up of a triangle's vertex: map, view vector and lights in texture space
# make -f tangent_faceted_verilator.mk        builds the C++ harness and runs it on the vectors
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run clean
run: obj_tangent_faceted/Vtangent_faceted
	obj_tangent_faceted/Vtangent_faceted tangent_faceted_vectors.txt
# Verilator would add -Os, which undoes -O2.
obj_tangent_faceted/Vtangent_faceted: $(HDL)/tangent_faceted.v tangent_faceted_harness.cpp
	verilator --cc --exe --build -Wall --Mdir obj_tangent_faceted -CFLAGS "-O2" \
	    -MAKEFLAGS "OPT_FAST= OPT_SLOW= OPT_GLOBAL=" $^
clean:
	rm -rf obj_tangent_faceted

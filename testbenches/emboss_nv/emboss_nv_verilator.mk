# emboss: texture coordinates displaced by the direction of a light, for embossing
# make -f emboss_nv_verilator.mk        builds the C++ harness and runs it on the vectors
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run clean
run: obj_emboss_nv/Vemboss_nv
	obj_emboss_nv/Vemboss_nv emboss_nv_vectors.txt
# Verilator would add -Os, which undoes -O2.
obj_emboss_nv/Vemboss_nv: $(HDL)/emboss_nv.v emboss_nv_harness.cpp
	verilator --cc --exe --build -Wall --Mdir obj_emboss_nv -CFLAGS "-O2" \
	    -MAKEFLAGS "OPT_FAST= OPT_SLOW= OPT_GLOBAL=" $^
clean:
	rm -rf obj_emboss_nv

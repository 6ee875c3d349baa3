# rotation: turns a direction in polar form into the frame of a surface normal
# make -f rotation_corrected_verilator.mk        builds the C++ harness and runs it on the vectors
# HDL=DIR says where the module is, if not here.
HDL ?= .
TABLES = rotation_corrected_sincos.hex rotation_corrected_asin.hex rotation_corrected_recip_sin.hex rotation_corrected_recip_cos.hex rotation_corrected_atan.hex rotation_corrected_prop.hex
.PHONY: run clean
run: obj_rotation_corrected/Vrotation_corrected $(TABLES)
	obj_rotation_corrected/Vrotation_corrected rotation_corrected_vectors.txt
# Verilator would add -Os, which undoes -O2.
obj_rotation_corrected/Vrotation_corrected: $(HDL)/rotation_corrected.v rotation_corrected_harness.cpp
	verilator --cc --exe --build -Wall --Mdir obj_rotation_corrected -CFLAGS "-O2" \
	    -MAKEFLAGS "OPT_FAST= OPT_SLOW= OPT_GLOBAL=" $^
ifneq ($(HDL),.)
$(TABLES): %.hex: $(HDL)/%.hex
	cp $< $@
endif
clean:
	rm -rf obj_rotation_corrected

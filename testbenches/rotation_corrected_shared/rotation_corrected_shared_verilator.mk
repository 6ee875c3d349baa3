# rotation: turns a direction in polar form into the frame of a surface normal
# make -f rotation_corrected_shared_verilator.mk        builds the C++ harness and runs it on the vectors
# HDL=DIR says where the module is, if not here.
HDL ?= .
TABLES = rotation_corrected_shared_sincos.hex rotation_corrected_shared_asin.hex rotation_corrected_shared_recip_sin.hex rotation_corrected_shared_recip_cos.hex rotation_corrected_shared_atan.hex rotation_corrected_shared_prop.hex
.PHONY: run clean
run: obj_rotation_corrected_shared/Vrotation_corrected_shared $(TABLES)
	obj_rotation_corrected_shared/Vrotation_corrected_shared rotation_corrected_shared_vectors.txt
# Verilator would add -Os, which undoes -O2.
obj_rotation_corrected_shared/Vrotation_corrected_shared: $(HDL)/rotation_corrected_shared.v rotation_corrected_shared_harness.cpp
	verilator --cc --exe --build -Wall --Mdir obj_rotation_corrected_shared -CFLAGS "-O2" \
	    -MAKEFLAGS "OPT_FAST= OPT_SLOW= OPT_GLOBAL=" $^
ifneq ($(HDL),.)
$(TABLES): %.hex: $(HDL)/%.hex
	cp $< $@
endif
clean:
	rm -rf obj_rotation_corrected_shared

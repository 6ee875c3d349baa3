# rotation: turns a direction in polar form into the frame of a surface normal
# make -f rotation_corrected_shared_ghdl.mk             runs the VHDL testbench
# make -f rotation_corrected_shared_ghdl.mk wave        runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
TABLES = rotation_corrected_shared_sincos.hex rotation_corrected_shared_asin.hex rotation_corrected_shared_recip_sin.hex rotation_corrected_shared_recip_cos.hex rotation_corrected_shared_atan.hex rotation_corrected_shared_prop.hex
.PHONY: run wave clean
# A library for this module alone. It holds paths: after the folder has moved, make clean.
GHDL = --std=08 --workdir=ghdl_rotation_corrected_shared
run: ghdl_rotation_corrected_shared/work-obj08.cf $(TABLES)
	ghdl -r $(GHDL) rotation_corrected_shared_tb
wave: ghdl_rotation_corrected_shared/work-obj08.cf $(TABLES)
	ghdl -r $(GHDL) rotation_corrected_shared_tb --vcd=rotation_corrected_shared_tb.vcd
ghdl_rotation_corrected_shared/work-obj08.cf: $(HDL)/rotation_corrected_shared.vhd rotation_corrected_shared_tb.vhd
	rm -rf ghdl_rotation_corrected_shared
	mkdir ghdl_rotation_corrected_shared
	ghdl -a $(GHDL) $^
ifneq ($(HDL),.)
$(TABLES): %.hex: $(HDL)/%.hex
	cp $< $@
endif
clean:
	rm -rf ghdl_rotation_corrected_shared rotation_corrected_shared_tb.vcd

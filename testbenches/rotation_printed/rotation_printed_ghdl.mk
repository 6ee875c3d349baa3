# rotation: turns a direction in polar form into the frame of a surface normal
# make -f rotation_printed_ghdl.mk             runs the VHDL testbench
# make -f rotation_printed_ghdl.mk wave        runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
TABLES = rotation_printed_sincos.hex rotation_printed_asin.hex rotation_printed_recip_sin.hex rotation_printed_recip_cos.hex rotation_printed_atan.hex rotation_printed_prop.hex
.PHONY: run wave clean
# A library for this module alone. It holds paths: after the folder has moved, make clean.
GHDL = --std=08 --workdir=ghdl_rotation_printed
run: ghdl_rotation_printed/work-obj08.cf $(TABLES)
	ghdl -r $(GHDL) rotation_printed_tb
wave: ghdl_rotation_printed/work-obj08.cf $(TABLES)
	ghdl -r $(GHDL) rotation_printed_tb --vcd=rotation_printed_tb.vcd
ghdl_rotation_printed/work-obj08.cf: $(HDL)/rotation_printed.vhd rotation_printed_tb.vhd
	rm -rf ghdl_rotation_printed
	mkdir ghdl_rotation_printed
	ghdl -a $(GHDL) $^
ifneq ($(HDL),.)
$(TABLES): %.hex: $(HDL)/%.hex
	cp $< $@
endif
clean:
	rm -rf ghdl_rotation_printed rotation_printed_tb.vcd

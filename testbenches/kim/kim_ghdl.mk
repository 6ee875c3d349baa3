# kim: light of a bump-mapped pixel by a matrix of sines and cosines and polar dot products
# make -f kim_ghdl.mk             runs the VHDL testbench
# make -f kim_ghdl.mk wave        runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
TABLES = kim_sincos.hex kim_recip.hex kim_atan.hex kim_diffuse.hex kim_specular.hex
.PHONY: run wave clean
# A library for this module alone. It holds paths: after the folder has moved, make clean.
GHDL = --std=08 --workdir=ghdl_kim
run: ghdl_kim/work-obj08.cf $(TABLES)
	ghdl -r $(GHDL) kim_tb
wave: ghdl_kim/work-obj08.cf $(TABLES)
	ghdl -r $(GHDL) kim_tb --vcd=kim_tb.vcd
ghdl_kim/work-obj08.cf: $(HDL)/kim.vhd kim_tb.vhd
	rm -rf ghdl_kim
	mkdir ghdl_kim
	ghdl -a $(GHDL) $^
ifneq ($(HDL),.)
$(TABLES): %.hex: $(HDL)/%.hex
	cp $< $@
endif
clean:
	rm -rf ghdl_kim kim_tb.vcd

# kugler: light of a bump-mapped pixel by rotations and light maps, without dot products
# make -f kugler_ghdl.mk             runs the VHDL testbench
# make -f kugler_ghdl.mk wave        runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
TABLES = kugler_recip.hex kugler_atan.hex kugler_tilt_map.hex kugler_diffuse_map.hex kugler_specular_map.hex
.PHONY: run wave clean
# A library for this module alone. It holds paths: after the folder has moved, make clean.
GHDL = --std=08 --workdir=ghdl_kugler
run: ghdl_kugler/work-obj08.cf $(TABLES)
	ghdl -r $(GHDL) kugler_tb
wave: ghdl_kugler/work-obj08.cf $(TABLES)
	ghdl -r $(GHDL) kugler_tb --vcd=kugler_tb.vcd
ghdl_kugler/work-obj08.cf: $(HDL)/kugler.vhd kugler_tb.vhd
	rm -rf ghdl_kugler
	mkdir ghdl_kugler
	ghdl -a $(GHDL) $^
ifneq ($(HDL),.)
$(TABLES): %.hex: $(HDL)/%.hex
	cp $< $@
endif
clean:
	rm -rf ghdl_kugler kugler_tb.vcd

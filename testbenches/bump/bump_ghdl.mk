# bump: light of a bump-mapped pixel from light, halfway vector, normal and bump vector
# make -f bump_ghdl.mk             runs the VHDL testbench
# make -f bump_ghdl.mk wave        runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
TABLES = bump_sincos.hex bump_recip.hex bump_atan.hex bump_cos.hex bump_diffuse.hex bump_specular.hex
.PHONY: run wave clean
# A library for this module alone. It holds paths: after the folder has moved, make clean.
GHDL = --std=08 --workdir=ghdl_bump
run: ghdl_bump/work-obj08.cf $(TABLES)
	ghdl -r $(GHDL) bump_tb
wave: ghdl_bump/work-obj08.cf $(TABLES)
	ghdl -r $(GHDL) bump_tb --vcd=bump_tb.vcd
ghdl_bump/work-obj08.cf: $(HDL)/bump.vhd bump_tb.vhd
	rm -rf ghdl_bump
	mkdir ghdl_bump
	ghdl -a $(GHDL) $^
ifneq ($(HDL),.)
$(TABLES): %.hex: $(HDL)/%.hex
	cp $< $@
endif
clean:
	rm -rf ghdl_bump bump_tb.vcd

// What lets a part of a stage compute: it does where an item goes on, and in no other cycle. No output
// tells, as nobody looks at what is computed otherwise. Bound by the files of tests/rtl/enables.

module enable_checker (
  input logic clk_i,
  input logic rst_ni,
  input logic enable_i,
  input logic goes_on_i  // the item whose values the part computes
);

  always_ff @(posedge clk_i) begin
    if (rst_ni) begin
      assert (enable_i == goes_on_i)
      else $error("%m: enable is %b where an item %s", enable_i, goes_on_i ? "goes on" : "does not");
    end
  end

endmodule

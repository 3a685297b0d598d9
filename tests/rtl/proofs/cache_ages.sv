// A cache's ages: no two are alike, and none will be; the way that is used is the newest, and the
// order of the others stays.
// Refused with: cache_ages: < age -> > age
// Refused with: cache_ages: way_i +: WayBits] = '0 -> way_i +: WayBits] = 2'd1

module cache_ages_proof (
  input logic [7:0] ages_i,
  input logic [1:0] way_i
);

  logic [7:0] ages;
  logic [3:0] differ_before, differ_behind, in_order;

  cache_ages u_ages (
    .ages_i,
    .way_i,
    .ages_o(ages)
  );

  function automatic logic differ(input logic [7:0] all, input logic [1:0] way);
    differ = 1'b1;
    for (int unsigned other = 0; other < 4; other++) begin
      if (other[1:0] != way && all[2*other +: 2] == all[2*way +: 2]) begin
        differ = 1'b0;
      end
    end
  endfunction

  for (genvar way = 0; way < 4; way++) begin : g_way
    assign differ_before[way] = differ(ages_i, way[1:0]);
    assign differ_behind[way] = differ(ages, way[1:0]);
    always_comb begin
      in_order[way] = 1'b1;
      for (int unsigned other = 0; other < 4; other++) begin
        if (way_i != way && way_i != other[1:0] &&
            (ages_i[2*way +: 2] < ages_i[2*other +: 2]) !=
              (ages[2*way +: 2] < ages[2*other +: 2])) begin
          in_order[way] = 1'b0;
        end
      end
    end
  end

  always_comb begin
    assume (differ_before == 4'b1111);
    assert (differ_behind == 4'b1111);
    assert (ages[2*way_i +: 2] == 2'd0);
    assert (in_order == 4'b1111);
  end

endmodule

package lookout.panels;

/** Where the beams of a table of bearings meet: midway between neighbours, half a step outside the outer ones. */
final class BeamEdges {
    private static final double SINGLE_BEAM_STEP = Math.toRadians(1.0);

    private BeamEdges() {}

    /** One edge more than beams [rad], in their order. */
    static double[] of(double[] bearing) {
        int last = bearing.length - 1;
        double[] edges = new double[bearing.length + 1];
        for (int beam = 1; beam <= last; beam++) {
            edges[beam] = 0.5 * (bearing[beam - 1] + bearing[beam]);
        }
        double half = 0.5 * SINGLE_BEAM_STEP;
        edges[0] = bearing[0] - (last > 0 ? 0.5 * (bearing[1] - bearing[0]) : half);
        edges[last + 1] = bearing[last] + (last > 0 ? 0.5 * (bearing[last] - bearing[last - 1]) : half);
        return edges;
    }
}

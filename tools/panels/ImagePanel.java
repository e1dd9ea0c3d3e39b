package lookout.panels;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import lookout.sonar_image_t;

/** The newest image, bearings from left to right and ranges upwards, the strongest echo white. */
final class ImagePanel extends LivePanel {
    private static final int MARGIN = 18;
    private static final int MIN_COLUMNS = 256;  // So that uneven beams have the width that is theirs.

    private sonar_image_t image;
    private BufferedImage picture;

    ImagePanel(String channel) {
        listen(channel, bytes -> take(new sonar_image_t(bytes)));
    }

    private void take(sonar_image_t next) {
        if (next.num_beams < 1 || next.num_bins < 1) {
            throw new IllegalArgumentException("an image without beams or bins");
        }
        int largest = 1;
        for (short[] beam : next.intensity) {
            for (short value : beam) {
                largest = Math.max(largest, value);
            }
        }
        int[] beams = beamsByBearing(next.bearing, Math.max(MIN_COLUMNS, next.num_beams));
        BufferedImage drawn = new BufferedImage(beams.length, next.num_bins, BufferedImage.TYPE_INT_RGB);
        for (int column = 0; column < beams.length; column++) {
            for (int bin = 0; bin < next.num_bins; bin++) {
                float share = Math.max(0, next.intensity[beams[column]][bin]) / (float) largest;
                drawn.setRGB(column, next.num_bins - 1 - bin, new Color(share, 0.85f * share, 0.5f * share).getRGB());
            }
        }
        image = next;
        picture = drawn;
    }

    /** The beam of each column, where columns divide the sector evenly from port to starboard. */
    static int[] beamsByBearing(double[] bearing, int columns) {
        double[] edges = BeamEdges.of(bearing);
        double port = Math.min(edges[0], edges[edges.length - 1]);
        double starboard = Math.max(edges[0], edges[edges.length - 1]);
        int[] beams = new int[columns];
        for (int column = 0; column < columns; column++) {
            double at = port + (column + 0.5) / columns * (starboard - port);
            for (int beam = 1; beam < bearing.length; beam++) {
                if (Math.abs(bearing[beam] - at) < Math.abs(bearing[beams[column]] - at)) {
                    beams[column] = beam;
                }
            }
        }
        return beams;
    }

    @Override
    void paintPicture(Graphics2D g) {
        if (image == null) {
            g.drawString("no image yet", 8, 14);
            return;
        }
        g.drawImage(picture, 0, MARGIN, getWidth(), getHeight() - MARGIN, null);
        g.drawString(String.format("%d beams, %.1f to %.1f m, t = %.1f s", image.num_beams, image.first_range,
                image.first_range + (image.num_bins - 1) * image.range_step, image.utime * 1e-6), 8, 13);
    }
}

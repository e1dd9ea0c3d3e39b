package lookout.panels;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import lookout.sonar_image_t;

/** The newest image, beams from left to right and ranges upwards, the strongest echo white. */
final class ImagePanel extends LivePanel {
    private static final int MARGIN = 18;

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
        BufferedImage drawn = new BufferedImage(next.num_beams, next.num_bins, BufferedImage.TYPE_INT_RGB);
        for (int beam = 0; beam < next.num_beams; beam++) {
            for (int bin = 0; bin < next.num_bins; bin++) {
                float share = Math.max(0, next.intensity[beam][bin]) / (float) largest;
                drawn.setRGB(beam, next.num_bins - 1 - bin, new Color(share, 0.85f * share, 0.5f * share).getRGB());
            }
        }
        image = next;
        picture = drawn;
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

    return circle.x + circle.radius >= box.minX && circle.x - circle.radius <= box.maxX &&
           circle.y + circle.radius >= box.minY && circle.y - circle.radius <= box.maxY;
